// Ends in contact, and ways that touch: what exact arithmetic at angle 0 adds to the planner.
#include <array>
#include <cmath>
#include <utility>

#include "planar_planner/native/layers/taut_path.hpp"
#include "planner.hpp"
#include "tuning.hpp"

namespace planner {

// A path in place of one whose evidence cannot be written: exactly, without turning.
bool Planner::exact_instead(Answer& answer, const Configuration& start, const Goal& goal) {
  const auto* const own = std::get_if<Configuration>(&goal);
  if (own == nullptr || answer.ends_moved || !problem_.ablation.layers) return false;
  layer_ = decide_in_layer(problem_, start, *own);
  if (!layer_ || !layer_->chain.empty()) {
    layer_.reset();
    return false;
  }
  answer.path = report_path(layer_->waypoints);
  answer.statistics.decided_by = DecidedBy::kTautPath;
  answer.statistics.path_length = answer.path.length;
  answer.statistics.path_turning = answer.path.turning;
  answer.statistics.waypoints = answer.path.waypoints.size();
  return true;
}

// The exact decision is about the user's own ends.
bool Planner::layer_answer(Query& query, const Configuration& start, const Goal& goal) {
  const auto* const own = std::get_if<Configuration>(&goal);
  if (!problem_.ablation.layers || own == nullptr || query.lifted) return false;
  layer_ = decide_in_layer(problem_, start, *own);
  if (!layer_) return false;
  if (layer_->chain.empty()) return conclude_path(query, layer_->waypoints, DecidedBy::kTautPath);
  query.decide(Verdict::kNoPath, DecidedBy::kOddChain);
  return true;
}

// The cells tell no more, since what is left touches. A way on which the robot does not turn may.
void Planner::settle_resolution(Query& query, const Configuration& start, const Goal& goal) {
  if (layer_answer(query, start, goal)) return;
  if (query.in_contact) query.leave_undecided(*query.in_contact);
}

// A way at angle 0 from an end in contact to a place from which rounded arithmetic can go on.
bool Planner::leave_contact(Query& query, const Configuration& start, const Goal& goal,
                            const bool at_start) {
  const auto* const own_goal = std::get_if<Configuration>(&goal);
  const Configuration& other = own_goal != nullptr ? *own_goal : start;
  const Configuration& own = at_start ? start : other;
  if (!problem_.ablation.layers || own.theta != 0.0 || query.lifted) return false;
  const double reach = std::ldexp(problem_.robot.reach, -problem_.frame.exponent);
  const double finest = std::ldexp(1.0, std::ilogb(reach) - kWayOutLevels.back());
  // One lattice for both ends, so that one layer holds the evidence of both legs.
  std::optional<Layer> layer =
      make_layer(problem_, {0, {start.x, start.y}, {other.x, other.y}, finest},
                 {kMostLayerSums, kMostLayerVertices});
  if (!layer) return false;
  layer->start = at_start ? layer->start : layer->goal;
  layer->goal = layer->start;
  std::vector<std::int32_t> scratch;
  if (!is_free(*layer, layer->start, scratch)) return false;  // it overlaps by less than rounding
  std::array<Int64, kWayOutLevels.size()> lengths{};
  for (std::size_t k = 0; k < lengths.size(); ++k)
    lengths[k] =
        to_lattice(layer->lattice, std::ldexp(finest, kWayOutLevels.back() - kWayOutLevels[k]));
  const auto placed = [&](const LatticePoint p) -> std::optional<Configuration> {
    const std::optional<Vec2> at = to_user(layer->lattice, p);
    if (!at) return std::nullopt;
    return Configuration{at->x, at->y, 0.0};
  };
  const auto way = find_way_out(*layer, lengths, [&](const LatticePoint p) {
    const std::optional<Configuration> q = placed(p);
    return q && outside_bounds(problem_, *q) == 0.0 && segments_->is_free(scaled(problem_, *q));
  });
  if (!way) return false;
  std::vector<Configuration> leg;
  for (const LatticePoint p : *way) {
    const std::optional<Configuration> q = placed(p);
    if (!q) return false;
    leg.push_back(*q);
  }
  (at_start ? query.start : query.goal) = leg.back();
  if (at_start)
    query.legs.before = std::move(leg);
  else
    query.legs.after = {leg.rbegin(), leg.rend()};
  legs_layer_ = std::move(*layer);
  return true;
}

// The path with its exact legs. It may end some whole turns on from the goal's angle.
void Planner::add_exact_legs(Query& query) const {
  std::vector<Configuration> path = query.answer.path.waypoints;
  if (path.empty() || query.legs.empty()) return;
  std::vector<Configuration>& before = query.legs.before;
  std::vector<Configuration>& after = query.legs.after;
  if (!before.empty()) before.pop_back();  // which is the path's own first waypoint
  if (!after.empty()) after.erase(after.begin());
  for (Configuration& q : after) q.theta = path.back().theta;
  path.insert(path.begin(), before.begin(), before.end());
  path.insert(path.end(), after.begin(), after.end());
  query.answer.path = report_path(std::move(path));
}

void Planner::begin_path(Evidence& evidence) const {
  evidence.waypoints = last_.waypoints;
  evidence.exact_before = last_.exact_before;
  evidence.exact_after = last_.exact_after;
}

}  // namespace planner
