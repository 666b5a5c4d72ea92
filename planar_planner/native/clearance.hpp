// How near a certified path comes to contact.
#pragma once

#include <limits>
#include <vector>

#include "obstacle_tree.hpp"
#include "problem.hpp"
#include "segment.hpp"

namespace planner {

// Of the separation along the axes, which never exceeds the Euclidean distance. Planner units.
struct ClearanceBounds {
  double lower = std::numeric_limits<double>::infinity();  // certified
  double upper = std::numeric_limits<double>::infinity();  // the least found at any configuration
};

// Along the certified segments from each pose to the next: `lower` is within the factor
// 1 - tolerance of `upper`, unless `intervals` for each segment run out. Infinite where there is
// nothing to touch.
ClearanceBounds bound_clearance(const Problem& problem, ObstacleTree& tree,
                                const std::vector<Pose>& path, double tolerance, int intervals);

// The least clearance at the segments' middles: an upper bound, cheap.
double sampled_clearance(const Problem& problem, ObstacleTree& tree, const std::vector<Pose>& path);

}  // namespace planner
