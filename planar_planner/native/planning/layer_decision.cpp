#include "layer_decision.hpp"

#include <utility>

#include "planar_planner/native/layers/taut_path.hpp"
#include "tuning.hpp"

namespace planner {

std::optional<LayerDecision> decide_in_layer(const ScaledProblem& problem,
                                             const Configuration& start,
                                             const Configuration& goal) {
  if (start.theta != 0.0 || (problem.rotation && goal.theta != 0.0)) return std::nullopt;
  std::optional<Layer> layer = make_layer(problem, {0, {start.x, start.y}, {goal.x, goal.y}},
                                          {kMostLayerSums, kMostLayerVertices});
  if (!layer) return std::nullopt;
  std::vector<std::int32_t> scratch;
  if (!is_free(*layer, layer->start, scratch) || !is_free(*layer, layer->goal, scratch))
    return std::nullopt;
  LayerDecision decision;
  if (auto chain = find_odd_chain(*layer)) {
    if (problem.rotation) return std::nullopt;
    decision.chain = std::move(*chain);
  } else if (const auto path = find_taut_path(*layer)) {
    for (const LatticePoint p : *path) {
      const std::optional<Vec2> at = to_user(layer->lattice, p);
      if (!at) return std::nullopt;
      decision.waypoints.push_back({at->x, at->y, start.theta});
    }
  } else {
    return std::nullopt;
  }
  decision.layer = std::move(*layer);
  return decision;
}

}  // namespace planner
