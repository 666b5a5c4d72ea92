// A set of configurations over which a pair is judged: translations t + s1 g1 + s2 g2 with
// |s1|, |s2| <= 1, rotations by theta + delta with |delta| <= half_angle. A cell has
// g1 = (h_x, 0), g2 = (0, h_y); a face has one half-extent zero; a straight segment has one
// generator; a single configuration has none.
#pragma once

#include <span>
#include <vector>

#include "convex_piece.hpp"
#include "vec.hpp"

namespace pdg {

struct Rotation {
  double cos = 1.0;
  double sin = 0.0;
};

constexpr Vec2 rotate(const Rotation r, const Vec2 a) {
  return {r.cos * a.x - r.sin * a.y, r.sin * a.x + r.cos * a.y};
}

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

// The robot's pieces turned to the centre of a motion: vertices and normals of all pieces, one
// after another. piece i owns [first[i], first[i + 1]). A piece is turned when it is first asked
// for: most never come near an obstacle.
struct PosedRobot {
  Rotation rotation;
  mutable std::vector<Vec2> vertices;
  mutable std::vector<Vec2> normals;
  mutable std::vector<char> turned;  // by piece
};

}  // namespace pdg
