// How near a certified path comes to contact.
#pragma once

#include <limits>
#include <vector>

#include "planar_planner/native/world/obstacle_tree.hpp"
#include "planar_planner/native/world/scaled_problem.hpp"
#include "segment.hpp"

namespace planner {

// Bounds of a path's separation along the axes, which never exceeds the Euclidean distance; planner
// units.
struct ClearanceBounds {
  double lower = std::numeric_limits<double>::infinity();  // certified
  double upper = std::numeric_limits<double>::infinity();  // the least found at any configuration
};

// Along the certified segments from each configuration to the next: `lower` is within the factor
// 1 - tolerance of `upper`, unless `intervals` for each segment run out. Infinite where there is
// nothing to touch. `off`, if not empty, has for each segment how far the motion that is meant may
// be from it, at the same angle: both bounds are less by that, so `lower` holds for that motion,
// but `upper` need not.
ClearanceBounds bound_clearance(const ScaledProblem& problem, ObstacleTree& tree,
                                const std::vector<ScaledConfiguration>& path, double tolerance,
                                int intervals, const std::vector<double>& off = {});

// An estimate of the least clearance, cheap, and no bound: at the segments' middles only, so it may
// be too large; from the hulls of polygons that nobody has decomposed, where those are far enough,
// so it may be too small.
double sampled_clearance(const ScaledProblem& problem, ObstacleTree& tree,
                         const std::vector<ScaledConfiguration>& path);

}  // namespace planner
