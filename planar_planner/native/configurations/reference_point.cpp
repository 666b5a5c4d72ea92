#include "reference_point.hpp"

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

#include "pdg/native/geometry/convex_hull.hpp"
#include "pdg/native/geometry/enclosing_circle.hpp"
#include "pdg/native/geometry/motion.hpp"
#include "planar_planner/native/tolerances.hpp"
#include "quarter_turn.hpp"
#include "tuning.hpp"

namespace planner {

namespace {

using Coordinate = double Vec2::*;

// Is a - b a double? Knuth's sum gives its rounding error exactly.
bool exact_difference(const double a, const double b) {
  const double difference = a - b;
  const double part = difference - a;
  return (a - (difference - part)) - (b + part) == 0.0;
}

double rounded_to(const double value, const int exponent) {
  return std::ldexp(std::round(std::ldexp(value, -exponent)), exponent);
}

// A number near `wanted` whose differences with that coordinate of all points are exact: of the
// grids on which it may lie the finest. 0 always is one.
double exact_origin(const std::span<const Vec2> points, const Coordinate along,
                    const double wanted) {
  double low = points[0].*along;
  double high = low;
  for (const Vec2 p : points) {
    low = std::min(low, p.*along);
    high = std::max(high, p.*along);
  }
  const double largest = std::max(std::abs(low), std::abs(high));
  if (!(high > low) || wanted == 0.0) return 0.0;
  const int coarsest = std::ilogb(high - low) - kOriginGridBits;
  // Where low is at least high - low, the first grid will do: every number there is a multiple of
  // the unit of low, and no difference is more than 2^53 of those.
  for (int grid = std::ilogb(largest) - kDoubleBits; grid <= coarsest; grid += kOriginGridStep) {
    const double origin = rounded_to(wanted, grid);
    if (std::all_of(points.begin(), points.end(),
                    [&](const Vec2 p) { return exact_difference(p.*along, origin); }))
      return origin;
  }
  return 0.0;
}

double farthest(const std::span<const Vec2> points, const Vec2 from) {
  double distance = 0.0;
  for (const Vec2 p : points) distance = std::max(distance, pdg::norm(p - from));
  return distance;
}

}  // namespace

std::optional<Vec2> body_point(const PolygonSet& robot) {
  const std::span<const Vec2> points = robot.points;
  if (points.empty()) return std::nullopt;
  Rectangle box = robot.bounds(0);
  for (std::size_t i = 1; i < robot.size(); ++i) {
    const Rectangle more = robot.bounds(i);
    box = {{std::min(box.low.x, more.low.x), std::min(box.low.y, more.low.y)},
           {std::max(box.high.x, more.high.x), std::max(box.high.y, more.high.y)}};
  }
  const Vec2 middle{0.5 * box.low.x + 0.5 * box.high.x, 0.5 * box.low.y + 0.5 * box.high.y};
  if (pdg::norm(middle) <= farthest(points, middle)) return std::nullopt;
  const Vec2 centre = pdg::smallest_enclosing_circle(
                          pdg::convex_hull(std::vector<Vec2>(points.begin(), points.end())))
                          .centre;
  const Vec2 point{exact_origin(points, &Vec2::x, centre.x),
                   exact_origin(points, &Vec2::y, centre.y)};
  if (farthest(points, point) >= farthest(points, {})) return std::nullopt;
  return point;
}

PolygonSet about_point(const PolygonSet& robot, const Vec2 point) {
  PolygonSet out = robot;
  for (Vec2& p : out.points) p = p - point;
  return out;
}

Configuration placed(const Vec2 point, const Configuration& q) {
  const Vec2 turned = pdg::rotate(rotation_at(q.theta), point);
  return {q.x + turned.x, q.y + turned.y, q.theta};
}

Configuration placed_back(const Vec2 point, const Configuration& q) {
  return placed({-point.x, -point.y}, q);
}

double turning_error(const Vec2 point, const double reach) {
  return kTurnedPointUnits * pdg::kUnitRoundoff * (std::abs(point.x) + std::abs(point.y) + reach);
}

}  // namespace planner
