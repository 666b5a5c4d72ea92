#include "path.hpp"

#include <algorithm>
#include <cmath>

namespace planner {

namespace {

// Least clearance is reported to this relative accuracy, unless the number of intervals runs out.
constexpr double kClearanceTolerance = 0.05;
constexpr int kClearanceIntervals = 400;
// While shortening, half of it is enough, and the part of it that a shortcut has to keep.
constexpr double kRoughTolerance = 0.5;
constexpr int kRoughIntervals = 20;
constexpr double kKeptClearance = 0.5;

}  // namespace

std::vector<Configuration> assemble_path(const Problem& problem, const Subdivision& subdivision,
                                         const std::vector<CellId>& channel,
                                         const std::vector<Connector>& links,
                                         const Configuration& start, const Configuration& goal,
                                         std::vector<CellId>& owners) {
  std::vector<Configuration> path{start};
  owners.clear();
  const bool turns = subdivision.space().rotation;
  // Within one cell theta spans a quarter turn, so the nearest representative is the right one.
  const auto append = [&](const Vec2 t, const std::uint64_t angle) {
    const double theta =
        turns ? nearest_turn(radians_of_turns(angle), path.back().theta) : start.theta;
    path.push_back(configuration_of(problem, {t, theta}));
  };
  for (std::size_t i = 0; i < channel.size(); ++i) {
    if (subdivision.cell(channel[i]).label == Label::kStar)
      append(subdivision.guard(channel[i]), subdivision.guard_turns(channel[i]));
    if (i < links.size()) append(links[i].t, links[i].turns);
    owners.resize(i < links.size() ? path.size() - 1 : path.size(), channel[i]);
  }
  const double theta = turns ? nearest_turn(goal.theta, path.back().theta) : start.theta;
  path.push_back({goal.x, goal.y, theta});
  return path;
}

std::optional<std::size_t> first_uncertified(const Problem& problem, SegmentTest& test,
                                             const std::vector<Configuration>& path,
                                             const Terminator& stop) {
  for (std::size_t i = 0; i + 1 < path.size(); ++i)
    if (stop() || !test.certify(pose_of(problem, path[i]), pose_of(problem, path[i + 1]))) return i;
  return std::nullopt;
}

void shorten(const Problem& problem, ObstacleTree& tree, SegmentTest& test,
             std::vector<Configuration>& path, const Terminator& stop) {
  ClearanceBounds clearance;
  for (std::size_t i = 0; i + 1 < path.size() && !stop(); ++i)
    bound_clearance(problem, tree, pose_of(problem, path[i]), pose_of(problem, path[i + 1]),
                    kRoughTolerance, kRoughIntervals, clearance);
  const double margin = kKeptClearance * clearance.lower;
  const auto certified = [&](const std::size_t from, const std::size_t to) {
    return test.certify(pose_of(problem, path[from]), pose_of(problem, path[to]), margin);
  };
  std::vector<Configuration> kept{path.front()};
  std::size_t i = 0;
  while (i + 1 < path.size()) {
    // Reach as far as a doubling stride goes, then one bisection back.
    std::size_t good = i + 1;
    std::size_t stride = 2;
    while (i + stride < path.size() && !stop() && certified(i, i + stride)) {
      good = i + stride;
      stride *= 2;
    }
    std::size_t bad = std::min(i + stride, path.size());
    while (bad - good > 1 && !stop()) {
      const std::size_t middle = good + (bad - good) / 2;
      if (certified(i, middle))
        good = middle;
      else
        bad = middle;
    }
    kept.push_back(path[good]);
    i = good;
  }
  path = std::move(kept);
}

PathReport report_path(const Problem& problem, ObstacleTree& tree,
                       std::vector<Configuration> waypoints) {
  PathReport report;
  ClearanceBounds clearance;
  for (std::size_t i = 0; i + 1 < waypoints.size(); ++i) {
    const Configuration& a = waypoints[i];
    const Configuration& b = waypoints[i + 1];
    report.length += std::hypot(b.x - a.x, b.y - a.y);
    report.turning += std::abs(b.theta - a.theta);
    bound_clearance(problem, tree, pose_of(problem, a), pose_of(problem, b), kClearanceTolerance,
                    kClearanceIntervals, clearance);
  }
  report.least_clearance = length_to_user(problem, clearance.lower);
  report.waypoints = std::move(waypoints);
  return report;
}

}  // namespace planner
