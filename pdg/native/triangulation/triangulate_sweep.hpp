// Triangles of the interior of simple rings by one plane sweep: the quick way for polygons in which
// nothing touches.
#pragma once

#include <optional>

#include "pdg/native/geometry/polygon.hpp"
#include "point_mesh.hpp"

namespace pdg {

// The mesh holds the triangles inside, by the even-odd rule, and nothing else; its half-edges
// without a twin are the polygon's edges, each marked odd. Exact: the triangles tile the interior.
// Nothing if a vertex comes twice or lies on an edge, edges cross or overlap, or a coordinate is
// out of range: then `triangulate` knows another way, and says what is wrong. Rings have at least
// three vertices.
std::optional<PointMesh> triangulate_sweep(const Polygon& polygon);

}  // namespace pdg
