#include "path.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "tuning.hpp"

namespace planner {

namespace {

bool looks_blocked(CollisionHint& hint, const ScaledConfiguration& from,
                   const ScaledConfiguration& to) {
  return std::any_of(kShortcutGlances.begin(), kShortcutGlances.end(),
                     [&](const double s) { return hint.gap(between(from, to, s)) < 0.0; });
}

std::vector<ScaledConfiguration> all_scaled(const ScaledProblem& problem,
                                            const std::vector<Configuration>& path) {
  std::vector<ScaledConfiguration> configurations;
  configurations.reserve(path.size());
  for (const Configuration& q : path) configurations.push_back(scaled(problem, q));
  return configurations;
}

}  // namespace

std::vector<Configuration> assemble_path(const ScaledProblem& problem,
                                         const Subdivision& subdivision,
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

std::optional<std::size_t> first_uncertified(const ScaledProblem& problem, SegmentTest& test,
                                             const std::vector<Configuration>& path,
                                             const Terminator& stop) {
  for (std::size_t i = 0; i + 1 < path.size(); ++i)
    if (stop() || !test.certify(scaled(problem, path[i]), scaled(problem, path[i + 1]))) return i;
  return std::nullopt;
}

std::optional<std::size_t> certify_shortened(const ScaledProblem& problem, ObstacleTree& tree,
                                             SegmentTest& test, CollisionHint& hint,
                                             std::vector<Configuration>& path,
                                             const Terminator& stop) {
  const std::vector<ScaledConfiguration> configurations = all_scaled(problem, path);
  const double margin = kKeptClearance * sampled_clearance(problem, tree, configurations);
  const auto shortcut = [&](const std::size_t from, const std::size_t to) {
    return !stop() && !looks_blocked(hint, configurations[from], configurations[to]) &&
           test.certify(configurations[from], configurations[to], margin);
  };
  std::vector<Configuration> kept{path.front()};
  std::size_t i = 0;
  while (i + 1 < path.size()) {
    // Reach as far as a doubling stride goes, then one bisection back.
    std::size_t good = i + 1;
    std::size_t stride = 2;
    while (i + stride < path.size() && shortcut(i, i + stride)) {
      good = i + stride;
      stride *= 2;
    }
    std::size_t bad = std::min(i + stride, path.size());
    while (bad - good > 1) {
      const std::size_t middle = good + (bad - good) / 2;
      if (shortcut(i, middle))
        good = middle;
      else
        bad = middle;
    }
    if (good == i + 1 && (stop() || !test.certify(configurations[i], configurations[good])))
      return i;
    kept.push_back(path[good]);
    i = good;
  }
  path = std::move(kept);
  return std::nullopt;
}

PathReport report_path(std::vector<Configuration> waypoints) {
  PathReport report;
  for (std::size_t i = 0; i + 1 < waypoints.size(); ++i) {
    const Configuration& a = waypoints[i];
    const Configuration& b = waypoints[i + 1];
    report.length += std::hypot(b.x - a.x, b.y - a.y);
    report.turning += std::abs(b.theta - a.theta);
  }
  report.waypoints = std::move(waypoints);
  return report;
}

double path_clearance(const ScaledProblem& problem, ObstacleTree& tree,
                      const std::vector<Configuration>& waypoints) {
  const ClearanceBounds clearance = bound_clearance(problem, tree, all_scaled(problem, waypoints),
                                                    kClearanceTolerance, kClearanceIntervals);
  return length_to_user(problem, clearance.lower);
}

}  // namespace planner
