#include "rrt_connect.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numbers>
#include <utility>

namespace planner {

namespace {

// Longest edge, relative to the diagonal of the domain: of 0.1 to 0.4, what solved most of the
// shipped scenes within a few hundred checks, over 21 seeds.
constexpr double kRange = 0.14;
// Nodes passed over by a search for the nearest that take as long as one question of the hint.
constexpr std::size_t kNodesPerCheck = 64;

constexpr double kHalfTurn = std::numbers::pi;

Pose wrapped(const Pose& pose) {
  return {pose.t, std::remainder(pose.theta, 2.0 * kHalfTurn)};
}

// The shorter way from one angle to another, both within half a turn of zero.
double turn_between(const double from, const double to) {
  const double turn = to - from;
  return turn > kHalfTurn    ? turn - 2.0 * kHalfTurn
         : turn < -kHalfTurn ? turn + 2.0 * kHalfTurn
                             : turn;
}

}  // namespace

std::vector<Configuration> RrtConnect::find(const Configuration& start, const Configuration& goal,
                                            const double spacing, const Terminator& stop) {
  spacing_ = spacing;
  range_ = kRange * pdg::norm(problem_.domain.size);
  Tree from_start{{wrapped(pose_of(problem_, start)), 0}};
  Tree from_goal{{wrapped(pose_of(problem_, goal)), 0}};
  theta_ = from_start[0].pose.theta;
  if (!problem_.rotation) from_goal[0].pose.theta = theta_;
  for (bool forward = true; !spent() && !stop(); forward = !forward) {
    Tree& here = forward ? from_start : from_goal;
    Tree& there = forward ? from_goal : from_start;
    if (extend(here, sample()) == Advance::kTrapped) continue;
    if (connect(there, here.back().pose) == Advance::kReached)
      return joined(from_start, from_goal, start, goal);
  }
  return {};
}

RrtConnect::Advance RrtConnect::extend(Tree& tree, const Pose& target) {
  return step(tree, nearest(tree, target), target);
}

RrtConnect::Advance RrtConnect::connect(Tree& tree, const Pose& target) {
  Advance advance = extend(tree, target);
  while (advance == Advance::kAdvanced)
    advance = step(tree, static_cast<std::uint32_t>(tree.size() - 1), target);
  return advance;
}

RrtConnect::Advance RrtConnect::step(Tree& tree, const std::uint32_t from, const Pose& target) {
  const Pose begin = tree[from].pose;
  const double way = std::sqrt(squared_distance(begin, target));
  const bool reaches = way <= range_;
  const Pose end = reaches ? target : towards(begin, target, range_ / way);
  if (!passes(begin, end)) return Advance::kTrapped;
  tree.push_back({end, from});
  return reaches ? Advance::kReached : Advance::kAdvanced;
}

std::uint32_t RrtConnect::nearest(const Tree& tree, const Pose& target) {
  budget_ -= static_cast<std::int64_t>(tree.size() / kNodesPerCheck);
  std::size_t best = 0;
  double least = INFINITY;
  for (std::size_t i = 0; i < tree.size(); ++i) {
    const double there = squared_distance(tree[i].pose, target);
    if (there < least) least = there, best = i;
  }
  return static_cast<std::uint32_t>(best);
}

// Asks about the far end, then ever finer between, but no finer where the gap covers the rest.
bool RrtConnect::passes(const Pose& from, const Pose& to) {
  const auto gap = [&](const Pose& pose) {
    if (spent()) return kCollides;
    --budget_;
    return hint_.gap(pose);
  };
  if (gap(to) < 0.0) return false;
  const double farthest = pdg::norm(to.t - from.t) +
                          problem_.robot.reach * std::abs(turn_between(from.theta, to.theta));
  const std::uint64_t parts = std::bit_ceil(static_cast<std::uint64_t>(farthest / spacing_) + 1);
  const double part = farthest / static_cast<double>(parts);
  middles_.assign(1, parts / 2);
  for (std::uint64_t half = parts / 2; half > 0; half /= 2) {
    next_.clear();
    for (const std::uint64_t middle : middles_) {
      const double s = static_cast<double>(middle) / static_cast<double>(parts);
      const double here = gap(towards(from, to, s));
      if (here < 0.0) return false;
      if (here >= part * static_cast<double>(half)) continue;
      next_.push_back(middle - half / 2);
      next_.push_back(middle + half / 2);
    }
    std::swap(middles_, next_);
  }
  return true;
}

Pose RrtConnect::towards(const Pose& from, const Pose& to, const double s) const {
  const double turn = turn_between(from.theta, to.theta);
  return {from.t + s * (to.t - from.t), turn_between(0.0, from.theta + s * turn)};
}

double RrtConnect::squared_distance(const Pose& a, const Pose& b) const {
  const Vec2 way = b.t - a.t;
  const double turn = problem_.robot.reach * turn_between(a.theta, b.theta);
  return dot(way, way) + turn * turn;
}

Pose RrtConnect::sample() {
  const Domain& d = problem_.domain;
  const Vec2 t = d.low + Vec2{random() * d.size.x, random() * d.size.y};
  return {t, problem_.rotation ? kHalfTurn * (2.0 * random() - 1.0) : theta_};
}

// SplitMix64 (Steele, Lea & Flood, OOPSLA 2014); uniform in [0, 1).
double RrtConnect::random() {
  state_ += 0x9e3779b97f4a7c15U;
  std::uint64_t z = state_;
  z = (z ^ (z >> 30U)) * 0xbf58476d1ce4e5b9U;
  z = (z ^ (z >> 27U)) * 0x94d049bb133111ebU;
  z ^= z >> 31U;
  return static_cast<double>(z >> 11U) * 0x1p-53;
}

// Both trees' last nodes are the same configuration; the ends are the user's own.
std::vector<Configuration> RrtConnect::joined(const Tree& from_start, const Tree& from_goal,
                                              const Configuration& start,
                                              const Configuration& goal) const {
  std::vector<Configuration> path;
  for (auto i = static_cast<std::uint32_t>(from_start.size() - 1); i != 0; i = from_start[i].parent)
    path.push_back(configuration_of(problem_, from_start[i].pose));
  path.push_back(start);
  std::reverse(path.begin(), path.end());
  for (auto i = from_goal.back().parent; i != 0; i = from_goal[i].parent)
    path.push_back(configuration_of(problem_, from_goal[i].pose));
  path.push_back(goal);
  for (std::size_t i = 1; i < path.size(); ++i)
    path[i].theta =
        problem_.rotation ? nearest_turn(path[i].theta, path[i - 1].theta) : start.theta;
  return path;
}

}  // namespace planner
