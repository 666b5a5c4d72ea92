// A convex piece with what the separating-axis functions need: vertices, outward unit normals and
// offsets, and its bounds. Half-planes (walls) are pieces with one edge and no vertex.
#pragma once

#include <vector>

#include "polygon.hpp"
#include "vec.hpp"

namespace pdg {

// Edge k runs from vertex k to vertex k + 1 (cyclic).
struct Edge {
  Vec2 vertex;          // its first end; invalid in a half-plane
  Vec2 normal;          // outward, unit length up to 4 u
  double offset = 0.0;  // normal . vertex
};

struct ConvexPiece {
  std::vector<Edge> edges;
  int vertex_count = 0;       // = edges.size(), or 0 for a half-plane
  Vec2 centre;                // of a bounding circle
  double radius = 0.0;        // its radius, rounded up; infinite for a half-plane
  Vec2 inner_centre;          // of a circle inside the piece
  double inner_radius = 0.0;  // its radius, rounded down
  double reach = 0.0;         // max |vertex| rounded up; |offset| for a half-plane
};

// The map from the user's frame to the frame of evaluation: (p - origin) 2^exponent.
struct Frame {
  Vec2 origin;
  int exponent = 0;
};

// One rounding a coordinate: relative error u of the difference.
Vec2 to_frame(const Frame& frame, Vec2 point);

// Normals come from the user's coordinates, whose differences carry one rounding only, so that
// they stay good far from the origin; vertices are mapped into the frame.
ConvexPiece make_piece(const ConvexPolygon& polygon, const Frame& frame);

// The solid half-plane {p : normal . p <= offset}, already in the frame of evaluation.
ConvexPiece make_half_plane(Vec2 normal, double offset);

}  // namespace pdg
