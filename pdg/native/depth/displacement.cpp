#include "displacement.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "pdg/native/geometry/enclosing_circle.hpp"
#include "pdg/native/tolerances.hpp"

namespace pdg {
namespace {

// R1 v + t1 - (R0 v + t0) = t1 - t0 + 2 sin(dtheta / 2) (R_mid v)^perp, R_mid half-way: no
// cancellation for small angles.
struct RelativeMotion {
  Vec2 shift;
  Rotation middle;
  double chord = 0.0;  // 2 sin(dtheta / 2)
  double angle = 0.0;  // |dtheta| modulo full turns, in [0, pi]
};

RelativeMotion relative_motion(const Pose& from, const Pose& to) {
  const double turn = std::remainder(to.theta - from.theta, 2.0 * std::numbers::pi);
  return {to.t - from.t, rotation_of(from.theta + 0.5 * turn), 2.0 * std::sin(0.5 * turn),
          std::abs(turn)};
}

double moved(const RelativeMotion& motion, const Vec2 v) {
  const Vec2 d = motion.shift + motion.chord * perp(rotate(motion.middle, v));
  return std::hypot(d.x, d.y);
}

double displacement(const PieceSet& body, const RelativeMotion& motion) {
  double most = 0.0;
  for (const Vec2 v : body.hull) most = std::max(most, moved(motion, v));
  return most;
}

// The errors of one displacement (length) and of the angle (radians), from above.
struct Errors {
  double moved = 0.0;
  double angle = 0.0;
};

Errors errors_of(const PieceSet& body, const Pose& from, const Pose& to) {
  const double angles = 1.0 + std::abs(from.theta) + std::abs(to.theta);
  const double lengths = norm(from.t) + norm(to.t) + body.radius * angles;
  return {kDisplacementErrorUnits * kUnitRoundoff * lengths,
          kTurnErrorUnits * kUnitRoundoff * angles};
}

// w^2 - k^2 from above; it grows with w.
double excess_from_above(const double angle) {
  const double chord = 2.0 * std::sin(0.5 * angle) / kRadiusPadding;
  return (angle - chord) * (angle + chord) * kRadiusPadding;
}

// The points that an upper bound's centre is to be near: displacement squared over the excess.
std::vector<WeightedPoint> weighted_vertices(const PieceSet& body, const RelativeMotion& motion,
                                             const double excess) {
  std::vector<WeightedPoint> points;
  for (const ConvexPolygon& polygon : body.polygons) {
    for (const Vec2 v : polygon) {
      const double m = excess > 0.0 ? moved(motion, v) : 0.0;
      points.push_back({v, excess > 0.0 ? m * m / excess : 0.0});
    }
  }
  return points;
}

// Longest trajectory, from above, when c moves straight while the body turns evenly.
double longest_trajectory(const PieceSet& body, const RelativeMotion& motion, const double excess,
                          const double error, const Vec2 c) {
  double most = 0.0;
  for (const ConvexPolygon& polygon : body.polygons) {
    for (const Vec2 v : polygon) {
      const double m = moved(motion, v) + error;
      const Vec2 d = v - c;
      most = std::max(most, m * m + excess * dot(d, d));
    }
  }
  return std::sqrt(most) * kRadiusPadding;
}

}  // namespace

double displacement(const PieceSet& body, const Pose& from, const Pose& to) {
  return displacement(body, relative_motion(from, to));
}

DistanceBounds generalized_distance_bounds(const PieceSet& body, const Pose& from, const Pose& to) {
  const RelativeMotion motion = relative_motion(from, to);
  const Errors error = errors_of(body, from, to);
  const double far = displacement(body, motion);
  const WeightedCentre middle = weighted_centre(weighted_vertices(body, motion, 0.0));
  const double radius = radius_from_below(middle);
  const double excess = excess_from_above(motion.angle + error.angle);
  // An excess that would not show beside the displacement leaves nothing to choose.
  const bool turns = excess * radius * radius > kUnitRoundoff * far * far;
  DistanceBounds bounds;
  bounds.centre = turns ? weighted_centre(weighted_vertices(body, motion, excess)).c : middle.c;
  bounds.lower = std::max({0.0, (far - error.moved) / kRadiusPadding,
                           (motion.angle - error.angle) * radius / kRadiusPadding});
  bounds.upper = longest_trajectory(body, motion, excess, error.moved, bounds.centre);
  return bounds;
}

}  // namespace pdg
