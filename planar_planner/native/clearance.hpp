// How near a certified path comes to contact.
#pragma once

#include <limits>

#include "obstacle_tree.hpp"
#include "problem.hpp"
#include "segment.hpp"

namespace planner {

// Of the separation along the axes, which never exceeds the Euclidean distance. Planner units.
struct ClearanceBounds {
  double lower = std::numeric_limits<double>::infinity();  // certified
  double upper = std::numeric_limits<double>::infinity();  // the least found at any configuration
};

// Lowers `clearance` to hold along one more certified segment: `lower` stays within the factor
// 1 - tolerance of `upper`, unless `intervals` run out. Infinite where there is nothing to touch.
void bound_clearance(const Problem& problem, ObstacleTree& tree, const Pose& from, const Pose& to,
                     double tolerance, int intervals, ClearanceBounds& clearance);

}  // namespace planner
