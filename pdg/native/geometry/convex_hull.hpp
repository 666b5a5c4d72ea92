// Convex hull of points, exact.
#pragma once

#include <vector>

#include "polygon.hpp"

namespace pdg {

// Strictly convex, counter-clockwise, some of the given points (none collinear with two others of
// the hull), from the lexicographically least on. Fewer than three points when all are collinear.
// Coordinates in the range of predicates.hpp.
ConvexPolygon convex_hull(std::vector<Vec2> points);

// The hull of all pieces' vertices.
ConvexPolygon convex_hull(const std::vector<ConvexPolygon>& polygons);

}  // namespace pdg
