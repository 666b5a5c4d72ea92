// Goals of a region for the first, cheap tries: before there are any cells.
#pragma once

#include <vector>

#include "planar_planner/native/configurations/goal_region.hpp"
#include "planar_planner/native/paths/collision.hpp"
#include "planar_planner/native/paths/segment.hpp"

namespace planner {

// Free ones near the start, the nearest first.
std::vector<Configuration> near_goals(const GoalRegion& region, SegmentTest& segments,
                                      const ScaledProblem& problem, const Configuration& start);

// Some all over the region, free as far as plain doubles tell; the same every time.
std::vector<Configuration> free_goals(const GoalRegion& region, CollisionHint& hint,
                                      const ScaledProblem& problem, const Configuration& start);

}  // namespace planner
