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
#include "tuning.hpp"

namespace planner {

inline constexpr LayerLimits kLayerLimits{kMostLayerSums, kMostLayerVertices};

struct LayerDecision {
  Layer layer;
  std::vector<ChainLink> chain;          // no path at this angle
  std::vector<Configuration> waypoints;  // a path; without this and a chain there is one, but not
                                         // of doubles, as far as was found
};

// Empty if the ends are not at the same quarter turn or not free, or if the problem is too large or
// its numbers share no lattice.
std::optional<LayerDecision> decide_in_layer(const ScaledProblem& problem,
                                             const Configuration& start, const Configuration& goal);

// The same for a goal region. Besides: a chain is one that does not meet the region.
std::optional<LayerDecision> decide_in_layer(const ScaledProblem& problem,
                                             const Configuration& start, const GoalSet& goal);

// Where exact arithmetic has a configuration at a quarter turn.
struct ExactPlacement {
  Layer layer;                     // of what is near
  std::optional<Overlap> overlap;  // with an obstacle
  std::optional<Side> beyond;      // the side of the workspace that the robot is beyond
  double depth = 0.0;              // of either, user's units

  [[nodiscard]] bool free() const { return !overlap && !beyond; }
};

// Empty at other angles, or if the numbers near by share no lattice.
std::optional<ExactPlacement> place_exactly(const ScaledProblem& problem, const Configuration& q);

}  // namespace planner
