// Ends in contact, and ways that touch: what exact arithmetic at quarter turns adds to the planner.
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "joined_path.hpp"
#include "planar_planner/native/cells/solid_regions.hpp"
#include "planar_planner/native/configurations/quarter_turn.hpp"
#include "planar_planner/native/layers/taut_path.hpp"
#include "planner.hpp"
#include "tuning.hpp"

namespace planner {

namespace {

Vec2 position(const Configuration& q) {
  return {q.x, q.y};
}

}  // namespace

// A path in place of one whose evidence cannot be written: exactly, without turning.
bool Planner::exact_instead(Answer& answer, const Configuration& start, const Goal& goal) {
  const auto* const own = std::get_if<Configuration>(&goal);
  if (own == nullptr || answer.ends_moved || !problem_.ablation.layers) return false;
  layer_ = decide_in_layer(problem_, start, *own);
  if (!layer_ || layer_->waypoints.empty()) {
    layer_.reset();
    return false;
  }
  answer.exact.clear();
  answer.path = report_path(layer_->waypoints);
  answer.statistics.decided_by = DecidedBy::kTautPath;
  answer.statistics.path_length = answer.path.length;
  answer.statistics.path_turning = answer.path.turning;
  answer.statistics.waypoints = answer.path.waypoints.size();
  return true;
}

// The exact decision is about the user's own ends.
bool Planner::layer_answer(Query& query, const Configuration& start, const Goal& goal) {
  if (!problem_.ablation.layers || query.lifted) return false;
  layer_ = std::visit([&](const auto& own) { return decide_in_layer(problem_, start, own); }, goal);
  if (layer_ && !layer_->waypoints.empty())
    return conclude_path(query, layer_->waypoints, DecidedBy::kTautPath);
  if (layer_ && !layer_->chain.empty() && !problem_.rotation) {
    query.decide(Verdict::kNoPath, DecidedBy::kOddChain);
    return true;
  }
  query.no_doubles = layer_ && layer_->chain.empty();
  layer_.reset();
  return false;
}

// The cells tell no more, since what is left touches. Ways on which the robot does not turn may.
void Planner::settle_resolution(Query& query, const Configuration& start, const Goal& goal) {
  if (layer_answer(query, start, goal)) return;
  const LayerJoin joined = join_layers(query, goal);
  if (joined == LayerJoin::kPath) return;
  if (query.no_doubles)
    query.leave_undecided(StopReason::kNoDoubles);
  else if (query.in_contact)
    query.leave_undecided(*query.in_contact);
  else if (joined == LayerJoin::kNone)
    query.leave_undecided(StopReason::kTightTurn);
}

// A way at a quarter turn from an end in contact to a place from which rounded arithmetic can go
// on.
bool Planner::leave_contact(Query& query, const Configuration& start, const Goal& goal,
                            const bool at_start) {
  const auto* const own_goal = std::get_if<Configuration>(&goal);
  const Configuration& own = at_start || own_goal == nullptr ? start : *own_goal;
  const std::optional<std::int64_t> quarters = quarters_of(own.theta);
  if (!problem_.ablation.layers || !quarters || query.lifted) return false;
  const double reach = std::ldexp(problem_.robot.reach, -problem_.frame.exponent);
  const double finest = std::ldexp(1.0, std::ilogb(reach) - kWayOutLevels.back());
  std::optional<Layer> layer = make_layer(
      problem_, {within_turn(*quarters), {own.x, own.y}, {own.x, own.y}, finest}, kLayerLimits);
  if (!layer) return false;
  std::vector<std::int32_t> scratch;
  if (!is_free(*layer, layer->start, scratch)) return false;  // it overlaps by less than rounding
  std::array<Int64, kWayOutLevels.size()> lengths{};
  for (std::size_t k = 0; k < lengths.size(); ++k)
    lengths[k] =
        to_lattice(layer->lattice, std::ldexp(finest, kWayOutLevels.back() - kWayOutLevels[k]));
  const auto way = find_way_out(*layer, lengths, [&](const LatticePoint p) {
    const std::optional<Vec2> at = to_user(layer->lattice, p);
    if (!at) return false;
    const Configuration q{at->x, at->y, own.theta};
    return outside_bounds(problem_, q) == 0.0 && segments_->is_free(scaled(problem_, q));
  });
  if (!way) return false;
  std::optional<std::vector<Configuration>> leg = on_way(layer->lattice, *way, own.theta);
  if (!leg) return false;
  (at_start ? query.start : query.goal) = leg->back();
  if (!at_start) std::reverse(leg->begin(), leg->end());
  (at_start ? query.legs.before : query.legs.after) = {std::move(*leg), layers_.size()};
  layers_.push_back(std::move(*layer));
  return true;
}

// The path with its exact legs. It may end some whole turns on from the goal's angle.
void Planner::add_exact_legs(Query& query) const {
  if (query.answer.path.waypoints.empty() || query.legs.empty()) return;
  JoinedPath joined;
  if (!query.legs.before.way.empty()) joined.append(std::move(query.legs.before));
  joined.append(std::move(query.answer.path.waypoints), query.answer.exact);
  if (!query.legs.after.way.empty()) joined.append(std::move(query.legs.after));
  query.answer.path = report_path(std::move(joined.waypoints));
  query.answer.exact = std::move(joined.exact);
}

CellId Planner::leaf_of(const Configuration& q) const {
  return subdivision_->locate(dyadic_point(problem_, q));
}

// A certified path from one configuration to another through solid leaves that hang together.
std::optional<std::vector<Configuration>> Planner::through_leaves(const Query& query,
                                                                  const CellId from,
                                                                  const Configuration& start,
                                                                  const CellId to,
                                                                  const Configuration& goal) {
  const std::vector<CellId> way = solid_way(*subdivision_, *faces_, from, to);
  std::vector<Connector> connectors;
  for (std::size_t i = 0; i + 1 < way.size(); ++i) {
    const Link link = faces_->test(way[i], way[i + 1]);
    if (link.state != LinkState::kOpen) return std::nullopt;
    connectors.push_back(link.connector);
  }
  std::vector<CellId> owners;
  std::vector<Configuration> path =
      assemble_path(problem_, *subdivision_, way, connectors, start, goal, owners);
  CollisionHint hint(problem_, *tree_);
  const Terminator stop = [&] { return query.clock() >= query.limits.timeout; };
  if (certify_shortened(problem_, *tree_, *segments_, hint, path, stop)) return std::nullopt;
  return path;
}

// A path that turns in open leaves only, and passes what it touches exactly, without turning.
LayerJoin Planner::join_layers(Query& query, const Goal& goal) {
  const bool asked = problem_.ablation.layers && problem_.rotation && subdivision_ &&
                     std::holds_alternative<Configuration>(goal);
  if (!asked || query.lifted || query.in_contact) return LayerJoin::kUnknown;
  if (subdivision_->size() > kMostJoinedLeaves) return LayerJoin::kUnknown;
  const std::vector<std::uint32_t> regions = solid_regions(*subdivision_, *faces_);
  const CellId first = leaf_of(query.start);
  const CellId last = leaf_of(query.goal);
  if (regions[first] == kNoRegion || regions[last] == kNoRegion) return LayerJoin::kUnknown;
  Gates gates = find_gates(problem_, *subdivision_, regions);
  const std::vector<GateStep> steps = steps_between(gates.gates, regions[first], regions[last]);
  if (steps.empty()) return gates.complete ? LayerJoin::kNone : LayerJoin::kUnknown;
  JoinedPath joined;
  joined.waypoints = {query.start};
  CellId cell = first;
  std::size_t from = gates.gates.size();
  const std::size_t offset = layers_.size();
  for (const GateStep& step : steps) {
    const bool at_end = step.to == gates.gates.size();
    const CellId next = at_end ? last : gates.gates[step.to].cell;
    const Configuration& to = at_end ? query.goal : gates.gates[step.to].at;
    if (step.in_layer) {
      const Gate& gate = gates.gates[step.to];
      Layer& layer = gates.layers[gate.layer];
      layer.start = to_lattice(layer.lattice, position(gates.gates[from].at));
      layer.goal = to_lattice(layer.lattice, position(to));
      const auto way = find_taut_path(layer);
      auto leg = way ? on_way(layer.lattice, *way, to.theta) : std::nullopt;
      if (!leg) return LayerJoin::kUnknown;
      joined.append({std::move(*leg), offset + gate.layer});
    } else {
      auto part = through_leaves(query, cell, joined.waypoints.back(), next, to);
      if (!part) return LayerJoin::kUnknown;
      joined.append(std::move(*part), {});
    }
    cell = next;
    from = step.to;
  }
  for (Layer& layer : gates.layers) layers_.push_back(std::move(layer));
  query.answer.exact = std::move(joined.exact);
  conclude_path(query, std::move(joined.waypoints), DecidedBy::kJoinedLayers);
  return LayerJoin::kPath;
}

void Planner::begin_path(Evidence& evidence) const {
  evidence.waypoints = last_.waypoints;
  evidence.exact = last_.exact;
}

}  // namespace planner
