#include "rrt_connect.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numbers>
#include <utility>

#include "planar_planner/native/configurations/quarter_turn.hpp"
#include "tuning.hpp"

namespace planner {

namespace {

// Where a node is that has not been placed yet.
constexpr std::uint32_t kElsewhere = UINT32_MAX;

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

RrtConnect::RrtConnect(const ScaledProblem& problem, CollisionHint& hint,
                       const Configuration& start, const std::span<const Configuration> goals,
                       const std::uint64_t seed)
    : problem_(problem),
      hint_(hint),
      calls_before_(hint.calls()),
      work_before_(hint.work()),
      start_(start),
      goals_(goals.begin(), goals.end()),
      longest_(kLongestEdge * pdg::norm(problem.domain.size)),
      shortest_(std::min(longest_, kShortestEdge * problem.robot.reach)),
      longest_growth_(kLongestGrowth * problem.robot.reach),
      range_(longest_),
      state_(seed) {
  const ScaledConfiguration root = wrapped(scaled(problem, start));
  theta_ = root.theta;
  add(from_start_, root, 0);
  for (const Configuration& goal : goals_) {
    ScaledConfiguration q = wrapped(scaled(problem, goal));
    if (!problem.rotation) q.theta = theta_;
    add(from_goal_, q, static_cast<std::uint32_t>(from_goal_.nodes.size()));
  }
}

std::uint64_t RrtConnect::work() const {
  return kCheckWork * (hint_.calls() - calls_before_) + kHintWork * (hint_.work() - work_before_) +
         kNodeWork * passed_;
}

std::vector<Configuration> RrtConnect::find(const double spacing, const std::uint64_t most_work,
                                            const Terminator& stop) {
  spacing_ = spacing;
  most_work_ = most_work;
  for (; !spent() && !stop(); forward_ = !forward_) {
    take_stock();
    Tree& here = forward_ ? from_start_ : from_goal_;
    Tree& there = forward_ ? from_goal_ : from_start_;
    const std::size_t before = here.nodes.size();
    const bool lags = kLaggingBoxes * here.boxes.size() < there.boxes.size();
    near_ = lags && !near_;
    grow(here, sample(near_ ? &here : nullptr), longest_growth_);
    if (here.nodes.size() == before) continue;
    if (grow(there, here.nodes.back().q, INFINITY) == Advance::kReached) return joined();
  }
  return {};
}

// They grow as long as the last samples have led to some boxes that were empty.
void RrtConnect::take_stock() {
  if (++samples_ < kStockSamples) return;
  samples_ = 0;
  const std::size_t boxes = from_start_.boxes.size() + from_goal_.boxes.size();
  growing_ = boxes >= boxes_before_ + kNewBoxes;
  boxes_before_ = boxes;
}

// Boxes of a reach times a reach times an eighth of a turn.
std::uint64_t RrtConnect::box_of(const ScaledConfiguration& q) const {
  const Vec2 place = (1.0 / problem_.robot.reach) * (q.t - problem_.domain.low);
  const auto x = static_cast<std::uint64_t>(std::max(place.x, 0.0));
  const auto y = static_cast<std::uint64_t>(std::max(place.y, 0.0));
  const auto turn = static_cast<std::uint64_t>(8.0 * (q.theta + kHalfTurn) / (2.0 * kHalfTurn));
  return (x << 36U) + (y << 4U) + turn;
}

void RrtConnect::add(Tree& tree, const ScaledConfiguration& q, const std::uint32_t parent) {
  tree.nodes.push_back({q, parent});
  tree.places.add(point(q));
  tree.low = {std::min(tree.low.x, q.t.x), std::min(tree.low.y, q.t.y)};
  tree.high = {std::max(tree.high.x, q.t.x), std::max(tree.high.y, q.t.y)};
  tree.boxes.insert(box_of(q));
}

void RrtConnect::reject(const std::size_t segment) {
  const std::size_t of_start = way_from_start_.size() - 1;
  if (segment < of_start)
    hand_over(from_start_, way_from_start_[segment + 1], from_goal_);
  else
    hand_over(from_goal_, way_from_goal_[segment - of_start], from_start_);
}

// What grew from `root`, the tree's last node with it, goes to the other tree. Both trees' last
// nodes are the same configuration, so the branch hangs there the other way round. Parents come
// before their children; a root of a tree is never handed over.
void RrtConnect::hand_over(Tree& tree, const std::uint32_t root, Tree& to) {
  const std::vector<Node> old = std::move(tree.nodes);
  std::vector<std::uint32_t> moved_to(old.size(), kElsewhere);
  std::vector<bool> leaves(old.size(), false);
  for (std::uint32_t i = root; i < old.size(); ++i)
    leaves[i] = i == root || (old[i].parent != i && leaves[old[i].parent]);
  auto last = static_cast<std::uint32_t>(old.size() - 1);
  moved_to[last] = static_cast<std::uint32_t>(to.nodes.size() - 1);
  for (std::uint32_t at = last; at != root; at = old[at].parent) {
    const std::uint32_t next = old[at].parent;
    add(to, old[next].q, moved_to[at]);
    moved_to[next] = static_cast<std::uint32_t>(to.nodes.size() - 1);
  }
  tree = {};
  for (std::uint32_t i = 0; i < old.size(); ++i) {
    if (moved_to[i] != kElsewhere) continue;
    Tree& home = leaves[i] ? to : tree;
    const auto place = static_cast<std::uint32_t>(home.nodes.size());
    add(home, old[i].q, old[i].parent == i ? place : moved_to[old[i].parent]);
    moved_to[i] = place;
  }
}

// Steps towards the target, for as long a way as that; what the last step did.
RrtConnect::Advance RrtConnect::grow(Tree& tree, const ScaledConfiguration& target,
                                     const double longest) {
  std::uint32_t from =
      tree.places.nearest(point(target), problem_.robot.reach * kHalfTurn, passed_);
  double way = 0.0;
  for (;;) {
    way += range_;
    const Advance advance = step(tree, from, target);
    if (advance != Advance::kAdvanced || way + range_ > longest) return advance;
    from = static_cast<std::uint32_t>(tree.nodes.size() - 1);
  }
}

RrtConnect::Advance RrtConnect::step(Tree& tree, const std::uint32_t from,
                                     const ScaledConfiguration& target) {
  const ScaledConfiguration begin = tree.nodes[from].q;
  const double way = std::sqrt(squared_distance(begin, target));
  const bool reaches = way <= range_;
  const ScaledConfiguration end = reaches ? target : towards(begin, target, range_ / way);
  if (!passes(begin, end)) {
    range_ = std::max(kShorterEdge * range_, shortest_);
    return Advance::kTrapped;
  }
  range_ = std::min(kLongerEdge * range_, longest_);
  add(tree, end, from);
  return reaches ? Advance::kReached : Advance::kAdvanced;
}

// A turn counts as its longest way.
RoundPoint RrtConnect::point(const ScaledConfiguration& q) const {
  return {q.t, problem_.robot.reach * q.theta};
}

// Asks about the far end, then ever finer between, but no finer where the gap covers the rest.
bool RrtConnect::passes(const ScaledConfiguration& from, const ScaledConfiguration& to) {
  const auto gap = [&](const ScaledConfiguration& q) { return spent() ? kCollides : hint_.gap(q); };
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

// From the whole domain, or from the surroundings of a tree. A tree in a pocket lags behind the
// other one, and finds the way out from near it: samples far away only draw it against the wall on
// their side.
ScaledConfiguration RrtConnect::sample(const Tree* const near) {
  const Domain& d = problem_.domain;
  Vec2 low = d.low;
  Vec2 size = d.size;
  if (near != nullptr) {
    const Vec2 end = low + size;
    const double by = kSurroundings * problem_.robot.reach;
    low = {std::max(low.x, near->low.x - by), std::max(low.y, near->low.y - by)};
    size = Vec2{std::min(end.x, near->high.x + by), std::min(end.y, near->high.y + by)} - low;
  }
  const Vec2 t = low + Vec2{random() * size.x, random() * size.y};
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
    path.push_back(configuration_of(problem_, from_start_.nodes[way_from_start_[i]].q));
  for (std::size_t i = 1; i + 1 < way_from_goal_.size(); ++i)
    path.push_back(configuration_of(problem_, from_goal_.nodes[way_from_goal_[i]].q));
  path.push_back(goals_[way_from_goal_.back()]);
  for (std::size_t i = 1; i < path.size(); ++i)
    path[i].theta =
        problem_.rotation ? nearest_turn(path[i].theta, path[i - 1].theta) : start_.theta;
  return path;
}

// Indices of the nodes from a root to the last one.
std::vector<std::uint32_t> RrtConnect::way_from_root(const Tree& tree) {
  std::vector<std::uint32_t> way{static_cast<std::uint32_t>(tree.nodes.size() - 1)};
  while (tree.nodes[way.back()].parent != way.back()) way.push_back(tree.nodes[way.back()].parent);
  std::reverse(way.begin(), way.end());
  return way;
}

}  // namespace planner
