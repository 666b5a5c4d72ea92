// Triangulation of a set of points, without constraints.
#pragma once

#include <vector>

#include "point_mesh.hpp"

namespace pdg {

// Delaunay-like triangulation of the convex hull of the points (sorted, distinct). Empty when all
// points are collinear.
PointMesh triangulate_points(std::vector<Vec2> sorted_points);

}  // namespace pdg
