#include "layer_decision.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "joined_path.hpp"
#include "planar_planner/native/configurations/quarter_turn.hpp"
#include "planar_planner/native/layers/taut_path.hpp"
#include "planar_planner/native/tolerances.hpp"

namespace planner {

namespace {

// The quarter turns of both ends, within a turn. A goal of a robot that may not turn has the
// start's angle.
std::optional<int> common_quarters(const ScaledProblem& problem, const Configuration& start,
                                   const Configuration& goal) {
  const std::optional<std::int64_t> own = quarters_of(start.theta);
  if (!own) return std::nullopt;
  const std::optional<std::int64_t> other = problem.rotation ? quarters_of(goal.theta) : own;
  if (!other || within_turn(*other) != within_turn(*own)) return std::nullopt;
  return within_turn(*own);
}

// Holds the robot at a quarter turn.
Rectangle robot_box(const ScaledProblem& problem, const Configuration& q) {
  const pdg::Rotation turned = rotation_at(q.theta);
  Rectangle box{{q.x, q.y}, {q.x, q.y}};
  double farthest = std::max(std::abs(q.x), std::abs(q.y));
  for (const Vec2 v : problem.given.robot.points) {
    const Vec2 p = Vec2{q.x, q.y} + pdg::rotate(turned, v);
    farthest = std::max({farthest, std::abs(v.x), std::abs(v.y)});
    box.low = {std::min(box.low.x, p.x), std::min(box.low.y, p.y)};
    box.high = {std::max(box.high.x, p.x), std::max(box.high.y, p.y)};
  }
  const double slack = kRobotBoxUnits * pdg::kUnitRoundoff * farthest;
  return {{box.low.x - slack, box.low.y - slack}, {box.high.x + slack, box.high.y + slack}};
}

// The side of the rectangle that a point is farthest beyond, and how far; empty inside.
std::optional<std::pair<Side, Int64>> side_beyond(const LatticeRectangle& r, const LatticePoint p) {
  const std::array<std::pair<Side, Int64>, 4> ways = {{{Side::kLeft, r.low.x - p.x},
                                                       {Side::kRight, p.x - r.high.x},
                                                       {Side::kBelow, r.low.y - p.y},
                                                       {Side::kAbove, p.y - r.high.y}}};
  const auto farthest = *std::max_element(
      ways.begin(), ways.end(), [](const auto& a, const auto& b) { return a.second < b.second; });
  return farthest.second > 0 ? std::optional(farthest) : std::nullopt;
}

// Does no set of the chain meet the region? Then a curve in the sets does not, and as the region's
// polygons are connected, it winds round all places of one as often.
bool misses_region(const Layer& layer, const std::vector<ChainLink>& chain) {
  const auto beyond = [&](const ChainLink side, const LatticePoint p) {
    const LatticeRectangle& r = layer.domain;
    return (side == link_of(Side::kLeft) && p.x < r.low.x) ||
           (side == link_of(Side::kRight) && p.x > r.high.x) ||
           (side == link_of(Side::kBelow) && p.y < r.low.y) ||
           (side == link_of(Side::kAbove) && p.y > r.high.y);
  };
  for (const LatticePolygon& piece : layer.region)
    for (const ChainLink link : chain) {
      const bool meets = link < 0 ? std::any_of(
                                        piece.begin(), piece.end(),
                                        [&](const LatticePoint p) { return beyond(link, p); })
                                  : overlap(layer.sums[static_cast<std::size_t>(link)], piece);
      if (meets) return false;
    }
  return true;
}

}  // namespace

std::optional<ExactPlacement> place_exactly(const ScaledProblem& problem, const Configuration& q) {
  const std::optional<std::int64_t> quarters = quarters_of(q.theta);
  if (!quarters) return std::nullopt;
  const Vec2 at{q.x, q.y};
  std::optional<Layer> layer = make_layer(
      problem, {within_turn(*quarters), at, at, 0.0, robot_box(problem, q)}, kLayerLimits);
  if (!layer) return std::nullopt;
  ExactPlacement out;
  out.overlap = deepest_overlap(*layer, layer->start);
  if (out.overlap) {
    out.depth = out.overlap->depth;
  } else if (const auto beyond = side_beyond(layer->domain, layer->start)) {
    out.beyond = beyond->first;
    out.depth = std::ldexp(static_cast<double>(beyond->second), layer->lattice.exponent);
  }
  out.layer = std::move(*layer);
  return out;
}

std::optional<LayerDecision> decide_in_layer(const ScaledProblem& problem,
                                             const Configuration& start,
                                             const Configuration& goal) {
  const std::optional<int> quarters = common_quarters(problem, start, goal);
  if (!quarters) return std::nullopt;
  std::optional<Layer> layer =
      make_layer(problem, {*quarters, {start.x, start.y}, {goal.x, goal.y}}, kLayerLimits);
  if (!layer) return std::nullopt;
  std::vector<std::int32_t> scratch;
  if (!is_free(*layer, layer->start, scratch) || !is_free(*layer, layer->goal, scratch))
    return std::nullopt;
  LayerDecision decision;
  if (auto chain = find_odd_chain(*layer)) {
    decision.chain = std::move(*chain);
  } else if (const auto path = find_taut_path(*layer)) {
    auto waypoints = on_way(layer->lattice, *path, start.theta);
    if (waypoints) decision.waypoints = std::move(*waypoints);
  }
  decision.layer = std::move(*layer);
  return decision;
}

std::optional<LayerDecision> decide_in_layer(const ScaledProblem& problem,
                                             const Configuration& start, const GoalSet& goal) {
  const std::optional<std::int64_t> quarters = quarters_of(start.theta);
  const bool arrived =
      !goal.angles || (goal.angles->low <= start.theta && start.theta <= goal.angles->high);
  if (!quarters || (problem.rotation && !arrived)) return std::nullopt;
  const Vec2 at{start.x, start.y};
  std::optional<Layer> layer = make_layer(
      problem, {within_turn(*quarters), at, at, 0.0, std::nullopt, &goal.polygons}, kLayerLimits);
  std::vector<std::int32_t> scratch;
  if (!layer || !is_free(*layer, layer->start, scratch)) return std::nullopt;
  LayerDecision decision;
  if (const auto way = find_way_into_region(*layer)) {
    auto waypoints = on_way(layer->lattice, *way, start.theta);
    if (waypoints) decision.waypoints = std::move(*waypoints);
  } else if (const auto place = free_place_in_region(*layer)) {
    layer->goal = *place;
    auto chain = find_odd_chain(*layer);
    if (chain && misses_region(*layer, *chain)) decision.chain = std::move(*chain);
  }
  if (decision.waypoints.empty() && decision.chain.empty()) return std::nullopt;
  decision.layer = std::move(*layer);
  return decision;
}

}  // namespace planner
