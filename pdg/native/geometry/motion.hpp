// A set of configurations over which a pair is judged: translations t + s1 g1 + s2 g2 with
// |s1|, |s2| <= 1, rotations by theta + delta with |delta| <= half_angle. A cell has
// g1 = (h_x, 0), g2 = (0, h_y); a face has one half-extent zero; a straight segment has one
// generator; a single configuration has none.
#pragma once

#include <cmath>
#include <cstdint>

#include "vec.hpp"

namespace pdg {

struct Rotation {
  double cos = 1.0;
  double sin = 0.0;
};

constexpr Vec2 rotate(const Rotation r, const Vec2 a) {
  return {r.cos * a.x - r.sin * a.y, r.sin * a.x + r.cos * a.y};
}

// How far a motion turns to either side of its centre.
struct HalfAngle {
  double angle = 0.0;  // radians, not negative
  double cos = 1.0;
  double sin = 0.0;
};

inline HalfAngle half_angle_of(const double angle) {
  return {angle, std::cos(angle), std::sin(angle)};
}

// Made by make_motion() and flattened(), which keep the fields consistent; `turn`, `margin` and
// `angle_error` depend on no other field but as they say.
struct Motion {
  Vec2 t;                   // centre of the translations
  Vec2 g1, g2;              // generators
  double g1_length = 0.0;   // |g1|
  double g2_length = 0.0;   // |g2|
  double half_angle = 0.0;  // radians, at most pi/2
  double cos_half = 1.0;
  double sin_half = 0.0;
  double turn = 0.0;    // straight segment: delta = s1 turn, |turn| = half_angle; 0: delta is free
  double reach = 0.0;   // bounds |t| over the whole set
  double margin = 0.0;  // separation demanded of a pair before it counts as apart
  double angle_error = 0.0;  // by how much (radians) the centre's angle may be off
};

// |g|; exact along an axis, also where the square would underflow.
inline double generator_length(const Vec2 g) {
  if (g.x == 0.0) return std::abs(g.y);
  return g.y == 0.0 ? std::abs(g.x) : norm(g);
}

// `reach` bounds |t| over the whole set. Everything that follows from the arguments is set here.
inline Motion make_motion(const Vec2 t, const Vec2 g1, const Vec2 g2, const HalfAngle& half,
                          const double reach) {
  Motion m;
  m.t = t;
  m.g1 = g1;
  m.g2 = g2;
  m.g1_length = generator_length(g1);
  m.g2_length = generator_length(g2);
  m.half_angle = half.angle;
  m.cos_half = half.cos;
  m.sin_half = half.sin;
  m.reach = reach;
  return m;
}

// A straight segment of configurations: t + s g and the angle's deviation s turn, |s| <= 1.
inline Motion make_segment_motion(const Vec2 t, const Vec2 g, const double turn,
                                  const double reach) {
  Motion m = make_motion(t, g, {}, half_angle_of(std::abs(turn)), reach);
  m.turn = turn;
  return m;
}

enum class MotionPart : std::uint8_t { kG1, kG2, kTurn };

// The part of the motion that has its centre and does not extend along `part`.
inline Motion flattened(const Motion& m, const MotionPart part) {
  const HalfAngle half{m.half_angle, m.cos_half, m.sin_half};
  const bool turns = part != MotionPart::kTurn;
  Motion out =
      make_motion(m.t, part == MotionPart::kG1 ? Vec2{} : m.g1,
                  part == MotionPart::kG2 ? Vec2{} : m.g2, turns ? half : HalfAngle{}, m.reach);
  out.turn = turns ? m.turn : 0.0;
  out.margin = m.margin;
  out.angle_error = m.angle_error;
  return out;
}

// Half-extent of the translations along n, in units of |n|.
inline double extent_along(const Motion& m, const Vec2 n) {
  return std::abs(dot(n, m.g1)) + std::abs(dot(n, m.g2));
}

// Half-extents of the smallest upright box that holds the translations.
inline Vec2 box_extent(const Motion& m) {
  return {std::abs(m.g1.x) + std::abs(m.g2.x), std::abs(m.g1.y) + std::abs(m.g2.y)};
}

// The single configuration at its centre.
inline Motion centre_of(const Motion& m) {
  return flattened(flattened(flattened(m, MotionPart::kG1), MotionPart::kG2), MotionPart::kTurn);
}

}  // namespace pdg
