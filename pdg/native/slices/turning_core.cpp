#include "turning_core.hpp"

#include <algorithm>
#include <cmath>

#include "pdg/native/geometry/motion.hpp"
#include "pdg/native/tolerances.hpp"

namespace pdg {
namespace {

// The rotation that takes the unit vector `from` to `to`, if it is within the turn.
bool faces(const Vec2 from, const Vec2 to, const Turn& turn, Rotation& by) {
  by = {dot(from, to), cross(from, to)};
  return by.cos > 0.0 && std::abs(by.sin) <= turn.sin + kAlignmentSlack;
}

// n . R(delta) a = (R(-delta) n) . a.
double least_at(const Vec2 n, const Rotation& delta, const std::span<const Vec2> vertices) {
  return least_along(rotate({delta.cos, -delta.sin}, n), vertices);
}

// max over the turn of min over a of n . R(delta) a.
double greatest_least(const Vec2 n, const SlicePiece& a, const Turn& turn) {
  double greatest = std::max(least_at(n, {turn.cos, turn.sin}, a.vertices),
                             least_at(n, {turn.cos, -turn.sin}, a.vertices));
  Rotation delta;
  for (const Vec2 m : a.normals) {
    if (faces(m, -n, turn, delta)) greatest = std::max(greatest, least_at(n, delta, a.vertices));
  }
  for (const Vec2 v : a.vertices) {
    const double radius = norm(v);
    if (radius <= greatest || radius == 0.0) continue;  // its peak is no higher
    if (faces((1.0 / radius) * v, n, turn, delta)) {
      greatest = std::max(greatest, least_at(n, delta, a.vertices));
    }
  }
  return greatest;
}

}  // namespace

Turn turn_by(const double half) {
  return {half, std::cos(half), std::sin(half)};
}

void add_turning_core(const SlicePiece& a, const SlicePiece& b, const Turn& turn,
                      ObstacleSlice& slice) {
  ObstacleSlice::Polygon polygon;
  polygon.box = difference_box(a.box, b.box);
  polygon.begin = static_cast<std::uint32_t>(slice.planes.size());
  for (std::size_t k = 0; k < b.normals.size(); ++k) {
    const Vec2 n = b.normals[k];
    slice.planes.push_back({n, dot(n, b.vertices[k]) - greatest_least(n, a, turn)});
  }
  for (std::size_t k = 0; k < a.normals.size(); ++k) {
    const Vec2 m = a.normals[k];
    double offset = dot(m, a.vertices[k]);
    if (offset > 0.0) offset *= turn.cos;
    const auto add = [&](const Rotation& delta) {
      const Vec2 turned = rotate(delta, m);
      slice.planes.push_back({-turned, offset - least_along(turned, b.vertices)});
    };
    add({turn.cos, -turn.sin});
    Rotation delta;
    for (const Vec2 n : b.normals) {
      if (faces(m, -n, turn, delta)) add(delta);
    }
    add({turn.cos, turn.sin});
  }
  polygon.end = static_cast<std::uint32_t>(slice.planes.size());
  slice.polygons.push_back(polygon);
}

}  // namespace pdg
