#include "ridge_path.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "tuning.hpp"

namespace planner {

bool RidgePath::spent() const {
  return statistics_.axis_work() >= most_ || (*stop_)();
}

// An upper bound of the way of the robot's farthest point.
double RidgePath::way(const ScaledConfiguration& from, const ScaledConfiguration& to) const {
  return pdg::norm(to.t - from.t) + problem_.robot.reach * std::abs(to.theta - from.theta);
}

// As it will be returned, so that what is certified is that.
ScaledConfiguration RidgePath::rounded(const ScaledConfiguration& q) const {
  return scaled(problem_, configuration_of(problem_, q));
}

// A guard, or the centre, with theta near the angle given.
ScaledConfiguration RidgePath::middle_of(const CellId id, const double near) const {
  const CellSpace& space = subdivision_.space();
  const CellBox& box = subdivision_.cell(id).box;
  const double theta =
      space.rotation ? nearest_turn(radians_of_turns(subdivision_.guard_turns(id)), near) : near;
  if (subdivision_.cell(id).label == Label::kStar) return {subdivision_.guard(id), theta};
  const Vec2 t = position_of(space, box.low[kX] + box.size(kX) / 2, box.low[kY] + box.size(kY) / 2);
  return {t, theta};
}

void RidgePath::begin(const std::uint64_t budget, const Terminator& stop) {
  most_ = budget == UINT64_MAX ? budget : statistics_.axis_work() + budget;
  stop_ = &stop;
}

Foothold RidgePath::foothold(const CellId id) {
  const Cell& cell = subdivision_.cell(id);
  const double theta = subdivision_.space().fixed_theta;
  const ScaledConfiguration middle = middle_of(id, theta);
  if (cell.solid()) return {rounded(middle), INFINITY, false};
  const ConstraintView undecided = subdivision_.undecided(id);
  const auto is_node = [](const PairHeader& pair) { return pair.robot == kNode; };
  if (std::any_of(undecided.pairs.begin(), undecided.pairs.end(), is_node))
    return {middle, 0.0, true};
  scope_.clear();
  climb_.add_axes(undecided, scope_);
  RidgeClimb::sort_axes(scope_);
  const double radius = cell.size * problem_.robot.reach;
  Height top = climb_.climb(middle, radius, scope_);
  if (problem_.rotation && !(top.clearance > 0.0)) top = crest(top, radius, cell.size);
  return {rounded(top.q), top.clearance, false};
}

// Where nothing opposes turning, the clearance has a smooth crest in theta, which linear steps do
// not see: it is found as the top of a parabola through the climbs from three angles.
Height RidgePath::crest(Height top, const double radius, double half_angle) {
  for (int i = 0; i < kCrestSteps; ++i, half_angle *= kNarrowerCrest) {
    const auto climbed = [&](const double by) {
      return climb_.climb({top.q.t, top.q.theta + by}, radius, scope_);
    };
    const Height below = climbed(-half_angle);
    const Height above = climbed(half_angle);
    const double bend = below.clearance - 2.0 * top.clearance + above.clearance;
    if (!(bend < 0.0)) return top;
    const double by = 0.5 * half_angle * (below.clearance - above.clearance) / bend;
    if (std::abs(by) > 2.0 * half_angle) return top;
    const Height there = climbed(by);
    for (const Height& other : {below, above, there})
      if (other.clearance > top.clearance) top = other;
  }
  return top;
}

bool RidgePath::join(const ScaledConfiguration& from, const ScaledConfiguration& to,
                     const std::vector<CellId>& cells, std::vector<ScaledConfiguration>& way) {
  look_between(cells, {from, 0, 0.0}, {to, cells.size() - 1, 0.0});
  return connect(from, to, kGapHalvings, way);
}

// One a cell, but for cells where none is found. False if the channel is too coarse yet.
bool RidgePath::find_footholds(const std::vector<CellId>& channel) {
  for (std::size_t i = 0; i < channel.size(); ++i) {
    const Cell& cell = subdivision_.cell(channel[i]);
    const ScaledConfiguration middle = middle_of(channel[i], footholds_.back().q.theta);
    if (cell.solid()) {
      footholds_.push_back({rounded(middle), i, INFINITY});
      continue;
    }
    const ConstraintView undecided = subdivision_.undecided(channel[i]);
    const auto is_node = [](const PairHeader& pair) { return pair.robot == kNode; };
    if (spent() || std::any_of(undecided.pairs.begin(), undecided.pairs.end(), is_node))
      return false;
    scope_.clear();
    climb_.add_axes(undecided, scope_);
    RidgeClimb::sort_axes(scope_);
    const Height top = climb_.climb(middle, cell.size * problem_.robot.reach, scope_);
    if (top.clearance > 0.0) footholds_.push_back({rounded(top.q), i, top.clearance});
  }
  return true;
}

// The tightest first: they are the likeliest to fail.
void RidgePath::list_gaps() {
  gaps_.clear();
  for (std::size_t i = 0; i + 1 < footholds_.size(); ++i) {
    const Step& from = footholds_[i];
    const Step& to = footholds_[i + 1];
    const bool missing = to.cell > from.cell + 1;
    gaps_.push_back({i, missing ? -1.0 : std::min(from.clearance, to.clearance), {}});
  }
  std::sort(gaps_.begin(), gaps_.end(), [](const Gap& a, const Gap& b) {
    return a.clearance < b.clearance || (a.clearance == b.clearance && a.from < b.from);
  });
}

void RidgePath::look_between(const std::vector<CellId>& channel, const Step& from, const Step& to) {
  scope_.clear();
  for (std::size_t i = from.cell; i <= to.cell; ++i) {
    const Label label = subdivision_.cell(channel[i]).label;
    if (label == Label::kMixed || label == Label::kStar)
      climb_.add_axes(subdivision_.undecided(channel[i]), scope_);
  }
  RidgeClimb::sort_axes(scope_);
}

// Where axes stay fixed, what they separate is nearly convex. A configuration separated by the axes
// of both ends is seen from both: before a gate, aligned with it.
Height RidgePath::between_axes(const ScaledConfiguration& from, const ScaledConfiguration& to,
                               const double radius) {
  const ScaledConfiguration middle = between(from, to, 0.5);
  for (const bool all_good : {true, false}) {
    both_.clear();
    for (const ScaledConfiguration& end : {from, to})
      if (all_good)
        climb_.add_good(end, scope_, both_);
      else
        climb_.add_best(end, scope_, both_);
    RidgeClimb::sort_axes(both_);
    const Height top = climb_.climb_all(middle, radius, both_);
    if (top.clearance > 0.0) return top;
  }
  return climb_.climb(middle, radius, scope_);
}

bool RidgePath::connect(const ScaledConfiguration& from, const ScaledConfiguration& to,
                        const int depth, std::vector<ScaledConfiguration>& configurations) {
  if (spent()) return false;
  if (segments_.certify(from, to)) {
    configurations.push_back(to);
    return true;
  }
  if (depth == 0) return false;
  const double radius = way(from, to);
  const Height top = between_axes(from, to, radius);
  if (!(top.clearance > 0.0) || way(between(from, to, 0.5), top.q) > radius) return false;
  const ScaledConfiguration there = rounded(top.q);
  return connect(from, there, depth - 1, configurations) &&
         connect(there, to, depth - 1, configurations);
}

std::vector<Configuration> RidgePath::find(const std::vector<CellId>& channel,
                                           const Configuration& start, const Configuration& goal,
                                           const std::uint64_t budget, const Terminator& stop) {
  begin(budget, stop);
  footholds_.assign(1, {scaled(problem_, start), 0, INFINITY});
  if (!find_footholds(channel)) return {};
  Configuration end = goal;
  const double theta = footholds_.back().q.theta;
  end.theta = problem_.rotation ? nearest_turn(goal.theta, theta) : start.theta;
  footholds_.push_back({scaled(problem_, end), channel.size() - 1, INFINITY});
  list_gaps();
  for (Gap& gap : gaps_) {
    const Step& from = footholds_[gap.from];
    const Step& to = footholds_[gap.from + 1];
    look_between(channel, from, to);
    if (!connect(from.q, to.q, kGapHalvings, gap.configurations)) return {};
  }
  std::sort(gaps_.begin(), gaps_.end(), [](const Gap& a, const Gap& b) { return a.from < b.from; });
  std::vector<Configuration> path{start};
  for (const Gap& gap : gaps_)
    for (const ScaledConfiguration& q : gap.configurations)
      path.push_back(configuration_of(problem_, q));
  path.back() = end;
  return path;
}

}  // namespace planner
