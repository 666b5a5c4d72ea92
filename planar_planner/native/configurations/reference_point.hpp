// The point of the robot that is planned about. Rotation about a point far from the body moves the
// body by that distance, so cells would have to be small in theta; about a point of the body they
// need not be. The shift is exact, so both problems have the same answer.
#pragma once

#include <optional>

#include "planar_planner/native/world/problem.hpp"

namespace planner {

// A point of the robot's frame near the centre of the body's smallest circle, such that every
// vertex minus the point is a double, exactly. Empty if the origin is no farther from the body than
// a point of it may be (inside the circle round its bounding box), or if no such point is nearer.
std::optional<Vec2> body_point(const PolygonSet& robot);

// The robot's polygons about the point: the same body, whose vertices are exact.
PolygonSet about_point(const PolygonSet& robot, Vec2 point);

// Where the point of the robot's frame is at q, with q's theta: x and y are off by at most
// turning_error().
Configuration placed(Vec2 point, const Configuration& q);
// The configuration of the robot's frame, given where the point of it is: the inverse.
Configuration placed_back(Vec2 point, const Configuration& q);
// Bounds the distance between what these return and the exact place, where |x| and |y| of both are
// at most `reach`.
double turning_error(Vec2 point, double reach);

}  // namespace planner
