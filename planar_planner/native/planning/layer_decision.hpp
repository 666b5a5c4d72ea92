// Translations at an orientation whose sine and cosine are exact, without rounding. Contact is
// free. A robot that may not turn has both verdicts so; one that may turn has the paths on which it
// does not.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "planar_planner/native/layers/layer.hpp"
#include "planar_planner/native/layers/odd_chain.hpp"
#include "planar_planner/native/world/scaled_problem.hpp"

namespace planner {

struct LayerDecision {
  Layer layer;
  std::vector<ChainLink> chain;          // no path
  std::vector<Configuration> waypoints;  // a path
};

// Empty if the ends are not at angle 0 or not free, if the problem is too large or its numbers
// share no lattice, if its way has corners that are no doubles, or if the robot would have to turn.
std::optional<LayerDecision> decide_in_layer(const ScaledProblem& problem,
                                             const Configuration& start, const Configuration& goal);

}  // namespace planner
