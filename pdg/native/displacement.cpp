#include "displacement.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

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

double largest_distance(const PieceSet& body, const Vec2 c) {
  double r = 0.0;
  for (const Vec2 v : body.hull) r = std::max(r, std::hypot(v.x - c.x, v.y - c.y));
  return r;
}

double displacement(const PieceSet& body, const RelativeMotion& motion) {
  double most = 0.0;
  for (const Vec2 v : body.hull) most = std::max(most, moved(motion, v));
  return most;
}

}  // namespace

double displacement(const PieceSet& body, const Pose& from, const Pose& to) {
  return displacement(body, relative_motion(from, to));
}

DistanceBounds generalized_distance_bounds(const PieceSet& body, const Pose& from, const Pose& to) {
  const RelativeMotion motion = relative_motion(from, to);
  const double lower = displacement(body, motion);
  if (motion.angle == 0.0) return {lower, lower};
  const auto straight_while_turning = [&](const Vec2 c) {
    return moved(motion, c) + largest_distance(body, c) * motion.angle;
  };
  double upper = lower * (0.5 * motion.angle) / std::sin(0.5 * motion.angle);
  upper = std::min(upper, straight_while_turning({0.0, 0.0}));
  for (const ConvexPolygon& polygon : body.polygons) {
    for (const Vec2 v : polygon) upper = std::min(upper, straight_while_turning(v));
  }
  return {lower, std::max(lower, upper)};
}

}  // namespace pdg
