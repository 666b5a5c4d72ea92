// Convex polygons in plain doubles, without margins: guesses at places, which prove nothing.
#pragma once

#include "pdg/native/geometry/polygon.hpp"
#include "planar_planner/native/world/problem.hpp"

namespace planner {

// The vertices are not empty.
Rectangle bounds_of(const pdg::ConvexPolygon& polygon);
bool inside_rectangle(const Rectangle& r, Vec2 p);
// Empty if nothing is left.
pdg::ConvexPolygon clipped(const pdg::ConvexPolygon& polygon, const Rectangle& r);
double area_of(const pdg::ConvexPolygon& polygon);
// Mean of the vertices: inside, up to rounding.
Vec2 middle_of(const pdg::ConvexPolygon& polygon);
// The point itself if it is inside.
Vec2 nearest_point(const pdg::ConvexPolygon& polygon, Vec2 p);
// A point of the polygon made from two numbers in [0, 1): uniform if they are.
Vec2 point_at(const pdg::ConvexPolygon& polygon, double u, double v);

}  // namespace planner
