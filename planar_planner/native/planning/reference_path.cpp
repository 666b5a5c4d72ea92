#include "reference_path.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "planar_planner/native/configurations/reference_point.hpp"
#include "planar_planner/native/paths/clearance.hpp"
#include "planar_planner/native/paths/tuning.hpp"
#include "planar_planner/native/tolerances.hpp"
#include "tuning.hpp"

namespace planner {

namespace {

// How far the point is from the straight segment between its own places, while the frame moves
// linearly in (x, y, theta) from one configuration to the other: its place is a linear function
// plus R(theta) c, whose second derivative along the segment has the length |c| turn^2, and which
// so is within an eighth of that of its chord. Planner units.
struct Deviation {
  double arc;
  double rounding;  // of the places
};
Deviation deviation(const ScaledProblem& about_body, const Vec2 point, const Configuration& from,
                    const Configuration& to) {
  const double turn = std::abs(to.theta - from.theta);
  const double length = pdg::norm(point);
  const double arc = length * turn * turn / 8.0 * (1.0 + kArcUnits * pdg::kUnitRoundoff);
  const double reach = std::max(std::max(std::abs(from.x), std::abs(from.y)),
                                std::max(std::abs(to.x), std::abs(to.y)));
  // Places of the point are within |c| of the frame's.
  const int exponent = about_body.frame.exponent;
  return {std::ldexp(arc, exponent), std::ldexp(turning_error(point, reach + length), exponent)};
}

class Retracing {
 public:
  Retracing(const ScaledProblem& about_body, SegmentTest& test, const Vec2 point,
            const Terminator& stop)
      : problem_(about_body), test_(test), point_(point), stop_(stop) {}

  // Appends the waypoints after `from`; false if some segment is not certified.
  bool append(const Configuration& from, const Configuration& to,
              const std::array<Configuration, 2>& body, std::vector<Configuration>& out,
              const int depth) {
    if (out.size() >= kMostReferenceWaypoints || stop_()) return false;
    const Deviation off = deviation(problem_, point_, from, to);
    const double margin = off.arc / kReferenceRoom + off.rounding;
    const ScaledConfiguration a = scaled(problem_, placed(point_, from));
    const ScaledConfiguration b = scaled(problem_, placed(point_, to));
    if (fits(a, b, margin) && test_.certify(a, b, margin)) {
      out.push_back(to);
      return true;
    }
    if (depth == kDeepestReferencePart || body[0].theta == body[1].theta) return false;
    const Configuration middle{0.5 * body[0].x + 0.5 * body[1].x, 0.5 * body[0].y + 0.5 * body[1].y,
                               0.5 * body[0].theta + 0.5 * body[1].theta};
    const Configuration between = placed_back(point_, middle);
    return append(from, between, {body[0], middle}, out, depth + 1) &&
           append(between, to, {middle, body[1]}, out, depth + 1);
  }

 private:
  // Is a certificate with this margin worth its work?
  bool fits(const ScaledConfiguration& a, const ScaledConfiguration& b, const double margin) {
    if (a.theta == b.theta) return true;
    const auto room = test_.clearance(between(a, b, 0.5));
    return room && margin <= *room;
  }

  const ScaledProblem& problem_;
  SegmentTest& test_;
  Vec2 point_;
  const Terminator& stop_;
};

}  // namespace

std::optional<std::vector<Configuration>> reference_path(const ScaledProblem& about_body,
                                                         SegmentTest& test, const Vec2 point,
                                                         const std::vector<Configuration>& path,
                                                         const Configuration& start,
                                                         const Configuration& goal,
                                                         const Terminator& stop) {
  Retracing retracing(about_body, test, point, stop);
  std::vector<Configuration> out{start};
  for (std::size_t i = 0; i + 1 < path.size(); ++i) {
    const bool last = i + 2 == path.size();
    const Configuration to =
        last ? Configuration{goal.x, goal.y, path.back().theta} : placed_back(point, path[i + 1]);
    if (!retracing.append(out.back(), to, {path[i], path[i + 1]}, out, 0)) return std::nullopt;
  }
  return out;
}

double reference_path_clearance(const ScaledProblem& about_body, ObstacleTree& tree,
                                const Vec2 point, const std::vector<Configuration>& waypoints) {
  std::vector<ScaledConfiguration> path;
  std::vector<double> off;
  for (std::size_t i = 0; i < waypoints.size(); ++i) {
    path.push_back(scaled(about_body, placed(point, waypoints[i])));
    if (i == 0) continue;
    const Deviation by = deviation(about_body, point, waypoints[i - 1], waypoints[i]);
    off.push_back(by.arc + by.rounding);
  }
  const ClearanceBounds clearance =
      bound_clearance(about_body, tree, path, kClearanceTolerance, kClearanceIntervals, off);
  return length_to_user(about_body, clearance.lower);
}

}  // namespace planner
