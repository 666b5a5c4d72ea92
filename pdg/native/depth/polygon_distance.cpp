#include "polygon_distance.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "pdg/native/geometry/predicates.hpp"
#include "pdg/native/tolerances.hpp"

namespace pdg {
namespace {

// Distance of a point from an edge of a polygon that it lies outside of, to a few u of itself.
NearestPoints nearest_on_edge(const Vec2 w, const Vec2 u, const Vec2 v) {
  const auto to_end = [&](const Vec2 end) {
    const Vec2 d = w - end;
    const double distance = std::hypot(d.x, d.y);
    return NearestPoints{distance, w, end, {d.x / distance, d.y / distance}};
  };
  if (dot_from(u, v, w) <= 0.0) return to_end(u);
  if (dot_from(v, u, w) <= 0.0) return to_end(v);
  const double area = signed_area(u, v, w);
  const Vec2 normal = edge_normal(u, v);
  return {std::abs(area) / std::hypot(v.x - u.x, v.y - u.y), w, closest_on_segment(w, u, v),
          area < 0.0 ? normal : -normal};
}

// Tries the vertices of one polygon against the edges of the other, plainly first, each distance
// off by `error`.
void try_vertices(const PlacedOutline& vertices, const PlacedOutline& edges,
                  const bool vertices_of_a, const double error, double& least,
                  NearestPoints& best) {
  const bool point = edges.vertices.size() == 1;  // its edge has no side
  for (std::size_t k = 0; k < edges.vertices.size(); ++k) {
    const Vec2 u = edges.vertices[k];
    const Vec2 v = next_vertex(edges.vertices, k);
    const Vec2 along = v - u;
    const double square = dot(along, along);
    for (const Vec2 w : vertices.vertices) {
      const Vec2 from = w - u;
      // The nearest point is on an edge that the vertex is in front of, and no nearer than its
      // line.
      const double before = dot(edges.normals[k], from);
      if (!point && (before < -error || before > least + 2.0 * error)) continue;
      const double t = std::clamp(dot(from, along) / square, 0.0, 1.0);
      const double plain = norm(from - t * along);
      if (plain > least + 2.0 * error) continue;  // a NaN goes on
      least = std::min(least, plain);
      const NearestPoints found = nearest_on_edge(w, u, v);
      if (found.distance >= best.distance) continue;
      best = found;
      best.vertex_of_a = vertices_of_a;
    }
  }
}

Vec2 farthest_along(const PlacedOutline& outline, const Vec2 direction) {
  Vec2 best = outline.vertices.front();
  for (const Vec2 v : outline.vertices)
    if (dot(direction, v) > dot(direction, best)) best = v;
  return best;
}

}  // namespace

Vec2 closest_on_segment(const Vec2 p, const Vec2 u, const Vec2 v) {
  const Vec2 along = v - u;
  const double t = dot(p - u, along) / dot(along, along);
  return u + std::clamp(t, 0.0, 1.0) * along;
}

NearestPoints polygon_distance(const PlacedOutline& a, const PlacedOutline& b) {
  const Box both = joined(a.box, b.box);
  const Vec2 extent = both.high - both.low;
  const double error = kGapErrorUnits * kUnitRoundoff * (extent.x + extent.y);
  // Two vertices that face each other bound the distance.
  const Vec2 towards_a = centre(a.box) - centre(b.box);
  double least = norm(farthest_along(a, -towards_a) - farthest_along(b, towards_a));
  NearestPoints best;
  try_vertices(a, b, true, error, least, best);
  try_vertices(b, a, false, error, least, best);
  return best;
}

}  // namespace pdg
