// A certified path of one point of the robot as a path of another, far from it. What is straight
// for a point of the body is an arc for the far one and the reverse, so the far point gets more
// waypoints: as many as keep the body within the room that it has.
#pragma once

#include <optional>
#include <vector>

#include "planar_planner/native/limits.hpp"
#include "planar_planner/native/paths/segment.hpp"
#include "planar_planner/native/world/problem.hpp"
#include "planar_planner/native/world/scaled_problem.hpp"

namespace planner {

// `path` is a certified path of `point` of the robot's frame in `about_body`, whose segment test
// `test` is. Returns waypoints of the frame itself, from `start` to `goal` (whose theta is the
// path's last), between which it moves linearly in (x, y, theta); every one of these segments is
// certified free. Empty if the room is too small for rounding, or a limit is reached.
std::optional<std::vector<Configuration>> reference_path(const ScaledProblem& about_body,
                                                         SegmentTest& test, Vec2 point,
                                                         const std::vector<Configuration>& path,
                                                         const Configuration& start,
                                                         const Configuration& goal,
                                                         const Terminator& stop);

// Certified lower bound of the clearance along such waypoints, user's units. It is less than what
// `path_clearance` finds by at most the part of the room that reference_path lets arcs take up.
double reference_path_clearance(const ScaledProblem& about_body, ObstacleTree& tree, Vec2 point,
                                const std::vector<Configuration>& waypoints);

}  // namespace planner
