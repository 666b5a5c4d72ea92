// Makes a short, certified path of a proven channel.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "clearance.hpp"
#include "collision.hpp"
#include "planar_planner/native/cells/face.hpp"
#include "planar_planner/native/cells/subdivision.hpp"
#include "planar_planner/native/limits.hpp"
#include "planar_planner/native/world/problem.hpp"
#include "planar_planner/native/world/scaled_problem.hpp"
#include "segment.hpp"

namespace planner {

struct PathReport {
  std::vector<Configuration> waypoints;  // user's units
  double length = 0.0;                   // of the reference point's way, user's units
  double turning = 0.0;                  // total |theta| change, radians
};

// start -> guards and connectors -> goal. links[i] joins channel[i] and channel[i + 1]; owners[k]
// is the leaf that holds segment k.
std::vector<Configuration> assemble_path(const ScaledProblem& problem,
                                         const Subdivision& subdivision,
                                         const std::vector<CellId>& channel,
                                         const std::vector<Connector>& links,
                                         const Configuration& start, const Configuration& goal,
                                         std::vector<CellId>& owners);

// The first segment that cannot be certified (or before which the terminator struck), if any.
std::optional<std::size_t> first_uncertified(const ScaledProblem& problem, SegmentTest& test,
                                             const std::vector<Configuration>& path,
                                             const Terminator& stop);

// Certifies every segment, and drops waypoints on the way where the shortcut is certified to keep
// half of the clearance found along the path; `hint` spares certificates that must fail.
// Deterministic; never longer. The first segment that cannot be certified (or before which the
// terminator struck), if any: `path` is then unchanged.
std::optional<std::size_t> certify_shortened(const ScaledProblem& problem, ObstacleTree& tree,
                                             SegmentTest& test, CollisionHint& hint,
                                             std::vector<Configuration>& path,
                                             const Terminator& stop);

PathReport report_path(std::vector<Configuration> waypoints);

// Certified lower bound of the clearance along a certified path, user's units.
double path_clearance(const ScaledProblem& problem, ObstacleTree& tree,
                      const std::vector<Configuration>& waypoints);

}  // namespace planner
