// Exact convex pieces of a polygon, without new vertices.
#pragma once

#include <vector>

#include "pdg/native/geometry/polygon.hpp"

namespace pdg {

// A convex cover: every piece is strictly convex, counter-clockwise, has input vertices only and
// lies inside the polygon, and the union of the pieces is exactly the polygon. Pieces may overlap:
// each is grown as far as convexity allows, because few large pieces decide more than many small
// ones. A convex polygon (one convex ring) is its own single piece and is not triangulated.
// A polygon without area has no pieces. Deterministic. Throws std::invalid_argument where
// triangulate does.
std::vector<ConvexPolygon> convex_pieces(const Polygon& polygon);

// The same without the growth: pieces with disjoint interiors.
std::vector<ConvexPolygon> convex_partition(const Polygon& polygon);

// The ring without its exactly collinear vertices, counter-clockwise, if it is convex; else empty.
ConvexPolygon as_convex(const Ring& ring);

}  // namespace pdg
