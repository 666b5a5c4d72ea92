// Distance of two disjoint convex polygons.
#pragma once

#include <limits>

#include "pdg/native/geometry/vec.hpp"
#include "placed_outline.hpp"

namespace pdg {

// A vertex of one polygon and the nearest point of the other.
struct NearestPoints {
  double distance = std::numeric_limits<double>::infinity();
  Vec2 vertex;
  Vec2 foot;                // rounded to the coordinates' doubles
  Vec2 away;                // unit, from foot to vertex; not a number when they coincide
  bool vertex_of_a = true;  // else it is b's, and the foot a's
};

// distance and away have a relative error of kRelativeDepthErrorUnits u, however small they are.
// The polygons' interiors are disjoint.
NearestPoints polygon_distance(const PlacedOutline& a, const PlacedOutline& b);

// The point of the segment u v next to p, in plain doubles.
Vec2 closest_on_segment(Vec2 p, Vec2 u, Vec2 v);

}  // namespace pdg
