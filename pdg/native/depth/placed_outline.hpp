// A convex polygon made ready for separating axes: vertices and the outward normals of its edges.
#pragma once

#include <cstddef>
#include <vector>

#include "pdg/native/geometry/box_tree.hpp"
#include "pdg/native/geometry/polygon.hpp"
#include "pdg/native/pieces/piece_set.hpp"

namespace pdg {

// Strictly convex, counter-clockwise. Edge k runs from vertex k to vertex k + 1 (cyclic).
struct PlacedOutline {
  ConvexPolygon vertices;
  std::vector<Vec2> normals;  // outward, unit length up to 4 u, of the vertices as they are here
  Box box;                    // of the vertices, exactly
};

// Throws std::invalid_argument for a coordinate outside the range of predicates.hpp.
PlacedOutline make_outline(ConvexPolygon polygon);

// The outline of the convex hull of the polygon's vertices as placed in doubles: rounding may turn
// slivers inside out, and the hull is what they then are, if need be a segment or a point (whose
// one edge has no normal). Reuses the memory of `out`. Throws as above.
void place_outline(const ConvexPolygon& polygon, const Pose& pose, PlacedOutline& out);

// What place_outline says of slivers, for a polygon that is placed already.
void restore_convexity(ConvexPolygon& placed);

inline Vec2 next_vertex(const ConvexPolygon& polygon, const std::size_t k) {
  return polygon[k + 1 == polygon.size() ? 0 : k + 1];
}

// Outward unit normal of the edge u -> v of a counter-clockwise polygon, good to 4 u.
Vec2 edge_normal(Vec2 u, Vec2 v);

}  // namespace pdg
