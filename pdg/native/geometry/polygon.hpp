// Polygons as they come from the user: the exact doubles, before any conversion.
#pragma once

#include <vector>

#include "vec.hpp"

namespace pdg {

// Closed ring without a repeated last vertex; consecutive vertices differ.
using Ring = std::vector<Vec2>;

// rings[0] is the outer boundary, the others are holes; any orientation.
struct Polygon {
  std::vector<Ring> rings;
};

// Strictly counter-clockwise convex vertices (no three in a row collinear).
using ConvexPolygon = std::vector<Vec2>;

}  // namespace pdg
