// Constrained triangulation of a polygon with holes, without new vertices.
#pragma once

#include <array>
#include <vector>

#include "pdg/native/geometry/polygon.hpp"
#include "point_mesh.hpp"

namespace pdg {

// Triangles that tile the polygon exactly.
struct Triangulation {
  std::vector<Vec2> points;                      // the distinct input vertices, sorted
  std::vector<std::array<Index, 3>> triangles;   // counter-clockwise, strictly
  std::vector<std::array<Index, 3>> neighbours;  // [k]: across edge k, k + 1; kNone on the boundary
};

// The interior is what an odd number of rings surrounds, so rings may have any orientation, may
// touch each other or themselves at vertices, and a vertex may lie on another edge; a stretch of
// boundary that is run through twice cancels. All decisions on topology are exact.
// Throws std::invalid_argument for a ring of fewer than three vertices, a coordinate outside the
// range of predicates.hpp, edges that cross at no common vertex, and a polygon that touches
// itself and would take minutes.
Triangulation triangulate(const Polygon& polygon);

}  // namespace pdg
