#include "path.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace planner {

namespace {

constexpr double kTurn = 2.0 * std::numbers::pi;
// Least clearance is reported to this relative accuracy, unless the number of intervals runs out.
constexpr double kClearanceTolerance = 0.05;
constexpr int kClearanceIntervals = 400;

// Moves a waypoint onto the reference bounds where rounding carried it out of them.
Vec2 clamped(const Problem& problem, const Vec2 p) {
  if (!problem.reference_bounds) return p;
  const Rectangle& r = *problem.reference_bounds;
  return {std::clamp(p.x, r.low.x, r.high.x), std::clamp(p.y, r.low.y, r.high.y)};
}


}  // namespace

Pose pose_of(const Problem& problem, const Configuration& q) {
  return {to_planner(problem, {q.x, q.y}), q.theta};
}

Configuration configuration_of(const Problem& problem, const Pose& pose) {
  const Vec2 p = clamped(problem, to_user(problem, pose.t));
  return {p.x, p.y, pose.theta};
}

double nearest_turn(const double angle, const double theta) {
  return angle + kTurn * std::round((theta - angle) / kTurn);
}

std::vector<Configuration> assemble_path(const Problem& problem, const Subdivision& subdivision,
                                         const std::vector<CellId>& channel,
                                         const std::vector<Connector>& links,
                                         const Configuration& start, const Configuration& goal) {
  std::vector<Configuration> path{start};
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
  }
  const double theta = turns ? nearest_turn(goal.theta, path.back().theta) : start.theta;
  path.push_back({goal.x, goal.y, theta});
  return path;
}

std::optional<std::size_t> first_uncertified(const Problem& problem, SegmentTest& test,
                                             const std::vector<Configuration>& path) {
  for (std::size_t i = 0; i + 1 < path.size(); ++i)
    if (!test.certify(pose_of(problem, path[i]), pose_of(problem, path[i + 1]))) return i;
  return std::nullopt;
}

void shorten(const Problem& problem, SegmentTest& test, std::vector<Configuration>& path) {
  std::vector<Configuration> kept{path.front()};
  std::size_t i = 0;
  while (i + 1 < path.size()) {
    // Reach as far as a doubling stride goes, then one bisection back.
    std::size_t good = i + 1;
    std::size_t stride = 2;
    std::size_t bad = path.size();
    while (i + stride < path.size() &&
           test.certify(pose_of(problem, path[i]), pose_of(problem, path[i + stride]))) {
      good = i + stride;
      stride *= 2;
    }
    bad = std::min(i + stride, path.size());
    while (bad - good > 1) {
      const std::size_t middle = good + (bad - good) / 2;
      if (test.certify(pose_of(problem, path[i]), pose_of(problem, path[middle])))
        good = middle;
      else
        bad = middle;
    }
    kept.push_back(path[good]);
    i = good;
  }
  path = std::move(kept);
}

PathReport report_path(const Problem& problem, SegmentTest& test,
                       std::vector<Configuration> waypoints) {
  PathReport report;
  double clearance = INFINITY;
  for (std::size_t i = 0; i + 1 < waypoints.size(); ++i) {
    const Configuration& a = waypoints[i];
    const Configuration& b = waypoints[i + 1];
    report.length += std::hypot(b.x - a.x, b.y - a.y);
    report.turning += std::abs(b.theta - a.theta);
    clearance = std::min(clearance, test.least_clearance(pose_of(problem, a), pose_of(problem, b),
                                                         clearance, kClearanceTolerance,
                                                         kClearanceIntervals));
  }
  report.least_clearance = length_to_user(problem, clearance);
  report.waypoints = std::move(waypoints);
  return report;
}

}  // namespace planner
