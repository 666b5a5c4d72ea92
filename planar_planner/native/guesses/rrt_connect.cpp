#include "rrt_connect.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numbers>
#include <numeric>
#include <utility>

#include "tuning.hpp"

namespace planner {

namespace {

// Where a node has been cut off.
constexpr std::uint32_t kCut = UINT32_MAX;

constexpr double kHalfTurn = std::numbers::pi;

ScaledConfiguration wrapped(const ScaledConfiguration& q) {
  return {q.t, std::remainder(q.theta, 2.0 * kHalfTurn)};
}

// The shorter way from one angle to another, both within half a turn of zero.
double turn_between(const double from, const double to) {
  const double turn = to - from;
  return turn > kHalfTurn    ? turn - 2.0 * kHalfTurn
         : turn < -kHalfTurn ? turn + 2.0 * kHalfTurn
                             : turn;
}

}  // namespace

RrtConnect::RrtConnect(const ScaledProblem& problem, CollisionHint& hint, const Budget& budget,
                       const Configuration& start, const std::span<const Configuration> goals)
    : problem_(problem),
      hint_(hint),
      budget_(static_cast<std::int64_t>(budget.checks)),
      most_work_(budget.work),
      start_(start),
      goals_(goals.begin(), goals.end()),
      longest_(kLongestEdge * pdg::norm(problem.domain.size)),
      shortest_(std::min(longest_, kShortestEdge * problem.robot.reach)),
      longest_growth_(kLongestGrowth * problem.robot.reach),
      range_(longest_),
      from_start_{{wrapped(scaled(problem, start)), 0}} {
  theta_ = from_start_[0].q.theta;
  for (const Configuration& goal : goals_) {
    from_goal_.push_back(
        {wrapped(scaled(problem, goal)), static_cast<std::uint32_t>(from_goal_.size())});
    if (!problem.rotation) from_goal_.back().q.theta = theta_;
  }
}

std::vector<Configuration> RrtConnect::find(const double spacing, const Terminator& stop) {
  spacing_ = spacing;
  for (; !spent() && !stop(); forward_ = !forward_) {
    Tree& here = forward_ ? from_start_ : from_goal_;
    Tree& there = forward_ ? from_goal_ : from_start_;
    const std::size_t before = here.size();
    grow(here, sample(), longest_growth_);
    if (here.size() == before) continue;
    if (grow(there, here.back().q, INFINITY) == Advance::kReached) return joined();
  }
  return {};
}

void RrtConnect::reject(const std::size_t segment) {
  const std::size_t of_start = way_from_start_.size() - 1;
  if (segment < of_start)
    cut(from_start_, way_from_start_[segment + 1]);
  else
    cut(from_goal_, way_from_goal_[segment - of_start]);
}

// Parents come before their children; a root is never cut.
void RrtConnect::cut(Tree& tree, const std::uint32_t root) {
  std::vector<std::uint32_t> moved_to(tree.size());
  std::uint32_t kept = root;
  std::iota(moved_to.begin(), moved_to.begin() + root, 0U);
  moved_to[root] = kCut;
  for (std::uint32_t i = root + 1; i < tree.size(); ++i) {
    const std::uint32_t parent = moved_to[tree[i].parent];
    moved_to[i] = parent == kCut ? kCut : kept;
    if (parent == kCut) continue;
    tree[kept] = tree[i];
    tree[kept++].parent = parent;
  }
  tree.resize(kept);
}

// Steps towards the target, for as long a way as that; what the last step did.
RrtConnect::Advance RrtConnect::grow(Tree& tree, const ScaledConfiguration& target,
                                     const double longest) {
  std::uint32_t from = nearest(tree, target);
  double way = 0.0;
  for (;;) {
    way += range_;
    const Advance advance = step(tree, from, target);
    if (advance != Advance::kAdvanced || way + range_ > longest) return advance;
    from = static_cast<std::uint32_t>(tree.size() - 1);
  }
}

RrtConnect::Advance RrtConnect::step(Tree& tree, const std::uint32_t from,
                                     const ScaledConfiguration& target) {
  const ScaledConfiguration begin = tree[from].q;
  const double way = std::sqrt(squared_distance(begin, target));
  const bool reaches = way <= range_;
  const ScaledConfiguration end = reaches ? target : towards(begin, target, range_ / way);
  if (!passes(begin, end)) {
    range_ = std::max(kShorterEdge * range_, shortest_);
    return Advance::kTrapped;
  }
  range_ = std::min(kLongerEdge * range_, longest_);
  tree.push_back({end, from});
  return reaches ? Advance::kReached : Advance::kAdvanced;
}

std::uint32_t RrtConnect::nearest(const Tree& tree, const ScaledConfiguration& target) {
  budget_ -= static_cast<std::int64_t>(tree.size() / kNodesPerCheck);
  std::size_t best = 0;
  double least = INFINITY;
  for (std::size_t i = 0; i < tree.size(); ++i) {
    const Vec2 way = target.t - tree[i].q.t;
    if (dot(way, way) >= least) continue;  // most are too far away without their turn
    const double there = squared_distance(tree[i].q, target);
    if (there < least) least = there, best = i;
  }
  return static_cast<std::uint32_t>(best);
}

// Asks about the far end, then ever finer between, but no finer where the gap covers the rest.
bool RrtConnect::passes(const ScaledConfiguration& from, const ScaledConfiguration& to) {
  const auto gap = [&](const ScaledConfiguration& q) {
    if (spent()) return kCollides;
    --budget_;
    return hint_.gap(q);
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

ScaledConfiguration RrtConnect::towards(const ScaledConfiguration& from,
                                        const ScaledConfiguration& to, const double s) const {
  const double turn = turn_between(from.theta, to.theta);
  return {from.t + s * (to.t - from.t), turn_between(0.0, from.theta + s * turn)};
}

double RrtConnect::squared_distance(const ScaledConfiguration& a,
                                    const ScaledConfiguration& b) const {
  const Vec2 way = b.t - a.t;
  const double turn = problem_.robot.reach * turn_between(a.theta, b.theta);
  return dot(way, way) + turn * turn;
}

ScaledConfiguration RrtConnect::sample() {
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
std::vector<Configuration> RrtConnect::joined() {
  way_from_start_ = way_from_root(from_start_);
  way_from_goal_ = way_from_root(from_goal_);
  std::reverse(way_from_goal_.begin(), way_from_goal_.end());
  std::vector<Configuration> path{start_};
  for (std::size_t i = 1; i < way_from_start_.size(); ++i)
    path.push_back(configuration_of(problem_, from_start_[way_from_start_[i]].q));
  for (std::size_t i = 1; i + 1 < way_from_goal_.size(); ++i)
    path.push_back(configuration_of(problem_, from_goal_[way_from_goal_[i]].q));
  path.push_back(goals_[way_from_goal_.back()]);
  for (std::size_t i = 1; i < path.size(); ++i)
    path[i].theta =
        problem_.rotation ? nearest_turn(path[i].theta, path[i - 1].theta) : start_.theta;
  return path;
}

// Indices of the nodes from a root to the last one.
std::vector<std::uint32_t> RrtConnect::way_from_root(const Tree& tree) {
  std::vector<std::uint32_t> way{static_cast<std::uint32_t>(tree.size() - 1)};
  while (tree[way.back()].parent != way.back()) way.push_back(tree[way.back()].parent);
  std::reverse(way.begin(), way.end());
  return way;
}

}  // namespace planner
