#include "placed_outline.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <utility>

#include "pdg/native/geometry/convex_hull.hpp"
#include "pdg/native/geometry/predicates.hpp"

namespace pdg {
namespace {

// A square in this range has neither overflowed nor underflowed.
constexpr double kLeastSquare = 0x1p-900;
constexpr double kLargestSquare = 0x1p900;

double length(const Vec2 a) {
  const double square = dot(a, a);
  return square >= kLeastSquare && square <= kLargestSquare ? std::sqrt(square)
                                                            : std::hypot(a.x, a.y);
}

// Strictly convex: only left turns, and once round (the edges' lexicographic direction changes
// exactly twice).
bool is_strictly_convex(const ConvexPolygon& ring) {
  const std::size_t n = ring.size();
  int changes = 0;
  for (std::size_t k = 0; k < n; ++k) {
    const Vec2 p = ring[k];
    const Vec2 u = ring[k + 1 < n ? k + 1 : k + 1 - n];
    const Vec2 q = ring[k + 2 < n ? k + 2 : k + 2 - n];
    if (orient2d(p, u, q) <= 0) return false;
    if (!passes_through(p, u, q)) ++changes;
  }
  return n >= 3 && changes == 2;
}

void finish(PlacedOutline& outline) {
  const ConvexPolygon& ring = outline.vertices;
  if (!std::all_of(ring.begin(), ring.end(), in_exact_range))
    throw std::invalid_argument("coordinate outside the range of exact arithmetic");
  outline.box = bounding_box(ring);
  outline.normals.resize(ring.size());
  for (std::size_t k = 0; k < ring.size(); ++k)
    outline.normals[k] = edge_normal(ring[k], next_vertex(ring, k));
}

}  // namespace

Vec2 edge_normal(const Vec2 u, const Vec2 v) {
  const Vec2 along = v - u;
  const double l = length(along);
  return {along.y / l, -(along.x / l)};
}

PlacedOutline make_outline(ConvexPolygon polygon) {
  PlacedOutline outline;
  outline.vertices = std::move(polygon);
  finish(outline);
  return outline;
}

void place_outline(const ConvexPolygon& polygon, const Pose& pose, PlacedOutline& out) {
  const Rotation rotation = rotation_of(pose.theta);
  out.vertices.clear();
  for (const Vec2 v : polygon) out.vertices.push_back(rotate(rotation, v) + pose.t);
  finish(out);
  if (is_strictly_convex(out.vertices)) return;
  out.vertices = convex_hull(std::move(out.vertices));
  finish(out);
}

void restore_convexity(ConvexPolygon& placed) {
  if (!is_strictly_convex(placed)) placed = convex_hull(std::move(placed));
}

}  // namespace pdg
