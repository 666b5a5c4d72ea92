// From a proven channel to a short, certified path.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "face.hpp"
#include "problem.hpp"
#include "scene.hpp"
#include "segment.hpp"
#include "subdivision.hpp"

namespace planner {

struct PathReport {
  std::vector<Configuration> waypoints;  // user's units
  double length = 0.0;                   // of the reference point's way, user's units
  double turning = 0.0;                  // total |theta| change, radians
  double least_clearance = 0.0;          // certified lower bound, user's units
};

// Rounds to the user's doubles and back: what is certified is what is returned.
Pose pose_of(const Problem& problem, const Configuration& q);
Configuration configuration_of(const Problem& problem, const Pose& pose);

// start -> guards and connectors -> goal. links[i] joins channel[i] and channel[i + 1].
std::vector<Configuration> assemble_path(const Problem& problem, const Subdivision& subdivision,
                                         const std::vector<CellId>& channel,
                                         const std::vector<Connector>& links,
                                         const Configuration& start, const Configuration& goal);

// The first segment that cannot be certified, if any.
std::optional<std::size_t> first_uncertified(const Problem& problem, SegmentTest& test,
                                             const std::vector<Configuration>& path);

// Drops waypoints while every new segment is certified. Deterministic; never longer.
void shorten(const Problem& problem, SegmentTest& test, std::vector<Configuration>& path);

PathReport report_path(const Problem& problem, SegmentTest& test,
                       std::vector<Configuration> waypoints);

// goal.theta plus the whole turns that bring it nearest to `theta`.
double nearest_turn(double angle, double theta);

}  // namespace planner
