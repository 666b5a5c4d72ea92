// Points are added one by one; after each the triangles round it are improved by flips.
#include "triangulate_points.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>

#include "insertion_order.hpp"
#include "pdg/native/geometry/predicates.hpp"
#include "tuning.hpp"

namespace pdg {
namespace {

constexpr std::size_t at(const Index i) {
  return static_cast<std::size_t>(i);
}

// The hull, counter-clockwise: the neighbours of each point on it.
struct Hull {
  std::vector<Index> next;
  std::vector<Index> prev;
};

// Triangle between the hull edge v -> n and the point p, which sees it. Returns its half-edge
// n -> v.
Index cover_hull_edge(PointMesh& mesh, const Index v, const Index n, const Index p) {
  const Index outer = mesh.hull_edge[at(v)];
  const Index h = add_triangle(mesh, n, v, p);
  link(mesh, h, outer);
  return h;
}

void join(PointMesh& mesh, Hull& hull, const Index a, const Index b, const Index half_edge) {
  hull.next[at(a)] = b;
  hull.prev[at(b)] = a;
  mesh.hull_edge[at(a)] = half_edge;
}

// Adds a point outside the hull, of which one of the hull edges at `start` is visible. The
// half-edges across from it, here and below, go into the empty list `across`.
void add_outside(PointMesh& mesh, Hull& hull, const Index p, const Index start,
                 std::vector<Index>& across) {
  const auto visible = [&](const Index a, const Index b) {
    return orient2d(mesh.point(a), mesh.point(b), mesh.point(p)) < 0;
  };
  Index after = start;          // end of the visible chain, counter-clockwise
  Index edge_to_after = kNone;  // half-edge p -> after
  while (visible(after, hull.next[at(after)])) {
    const Index n = hull.next[at(after)];
    const Index h = cover_hull_edge(mesh, after, n, p);
    if (edge_to_after != kNone) link(mesh, h + 1, edge_to_after);
    edge_to_after = h + 2;
    across.push_back(h);
    after = n;
  }
  Index before = start;
  Index edge_from_before = across.empty() ? kNone : across.front() + 1;  // before -> p
  while (visible(hull.prev[at(before)], before)) {
    const Index v = hull.prev[at(before)];
    const Index h = cover_hull_edge(mesh, v, before, p);
    if (edge_from_before != kNone) {
      link(mesh, h + 2, edge_from_before);
    } else {
      edge_to_after = h + 2;
    }
    edge_from_before = h + 1;
    across.push_back(h);
    before = v;
  }
  join(mesh, hull, before, p, edge_from_before);
  join(mesh, hull, p, after, edge_to_after);
}

// Triangles from the collinear points 0 .. apex - 1 to the first point off their line.
Hull start_hull(PointMesh& mesh, const Index apex) {
  const std::size_t n = mesh.points.size();
  Hull hull{std::vector<Index>(n, kNone), std::vector<Index>(n, kNone)};
  const bool left = orient2d(mesh.point(0), mesh.point(1), mesh.point(apex)) > 0;
  const Index last = apex - 1;
  Index previous_side = kNone;
  for (Index i = 0; i < last; ++i) {
    // Left: (i, i+1, apex); right: (i+1, i, apex). side_low and side_high meet at the apex.
    const Index h = left ? add_triangle(mesh, i, i + 1, apex) : add_triangle(mesh, i + 1, i, apex);
    const Index side_low = left ? h + 2 : h + 1;
    const Index side_high = left ? h + 1 : h + 2;
    if (previous_side != kNone) link(mesh, side_low, previous_side);
    previous_side = side_high;
    left ? join(mesh, hull, i, i + 1, h) : join(mesh, hull, i + 1, i, h);
    if (i == 0) left ? join(mesh, hull, apex, 0, side_low) : join(mesh, hull, 0, apex, side_low);
    if (i == last - 1) {
      left ? join(mesh, hull, last, apex, side_high) : join(mesh, hull, apex, last, side_high);
    }
  }
  return hull;
}

// Where a new point lies.
enum class Region : std::uint8_t { kTriangle, kEdge, kOutside };

struct Place {
  Region region;
  Index half_edge;   // of the triangle; the edge itself; not used outside
  Index hull_point;  // outside: one of the hull edges at this point sees the new one
};

// The first step of a walk from the vertex u to the point p.
struct Step {
  Index crossed = kNone;  // the edge across from u that the segment passes, from right to left
  Index along = kNone;    // or the edge at u that it runs along, and
  Index vertex = kNone;   // that edge's other end; neither: the segment leaves the hull at once
};

Step first_step(const PointMesh& mesh, const Index u, const Index p) {
  const Vec2 pu = mesh.point(u);
  const Vec2 target = mesh.point(p);
  const auto side = [&](const Index w) { return orient2d(pu, target, mesh.point(w)); };
  const auto ahead = [&](const Index w) { return !passes_through(target, pu, mesh.point(w)); };
  const Index start = first_outgoing(mesh, u);
  Index h = start;
  do {
    const Index to_u = PointMesh::prev(h);
    const Index a = mesh.to(h);
    const Index b = mesh.from(to_u);
    const int side_a = side(a);
    const int side_b = side(b);
    if (side_a == 0 && ahead(a)) return {kNone, h, a};
    if (side_b == 0 && ahead(b)) return {kNone, to_u, b};
    if (side_a < 0 && side_b > 0) return {PointMesh::next(h), kNone, kNone};
    h = rotate_ccw(mesh, h);
  } while (h != kNone && h != start);
  return {};
}

// Walks from the vertex u straight towards the point p, which is no vertex yet; where the line
// meets a vertex, on from there.
Place locate(const PointMesh& mesh, Index u, const Index p) {
  const Vec2 target = mesh.point(p);
  for (;;) {
    const Step step = first_step(mesh, u, p);
    if (step.vertex != kNone) {
      if (passes_through(mesh.point(u), target, mesh.point(step.vertex)))
        return {Region::kEdge, step.along, kNone};
      u = step.vertex;
      continue;
    }
    if (step.crossed == kNone) return {Region::kOutside, kNone, u};
    Index crossed = step.crossed;
    Index vertex = kNone;
    while (vertex == kNone) {
      const int within =
          orient2d(mesh.point(mesh.from(crossed)), mesh.point(mesh.to(crossed)), target);
      if (within > 0) return {Region::kTriangle, crossed, kNone};
      if (within == 0) return {Region::kEdge, crossed, kNone};
      const Index inner = mesh.opposite(crossed);
      if (inner == kNone) return {Region::kOutside, kNone, mesh.from(crossed)};
      const Index apex = mesh.from(PointMesh::prev(inner));
      const int side = orient2d(mesh.point(u), target, mesh.point(apex));
      if (side == 0) {
        if (passes_through(mesh.point(u), target, mesh.point(apex)))
          return {Region::kTriangle, inner, kNone};
        vertex = apex;
      }
      crossed = side < 0 ? PointMesh::prev(inner) : PointMesh::next(inner);
    }
    u = vertex;
  }
}

// Splits a triangle at the point p in it or on one of its edges. Of the three half-edges across
// from p, which it returns, the k-th is the triangle's k-th edge.
std::array<Index, 3> split_triangle(PointMesh& mesh, const Index triangle, const Index p) {
  const Index first = 3 * triangle;
  const Index a = mesh.from(first);
  const Index b = mesh.from(first + 1);
  const Index c = mesh.from(first + 2);
  const Index beyond_bc = mesh.opposite(first + 1);
  const Index beyond_ca = mesh.opposite(first + 2);
  replace_corner(mesh, first + 2, p);  // (a, b, p) stays in the triangle's slots
  const Index second = add_triangle(mesh, b, c, p);
  const Index third = add_triangle(mesh, c, a, p);
  link(mesh, second, beyond_bc);
  link(mesh, third, beyond_ca);
  if (beyond_bc == kNone) mesh.hull_edge[at(b)] = second;
  if (beyond_ca == kNone) mesh.hull_edge[at(c)] = third;
  link(mesh, first + 1, second + 2);
  link(mesh, second + 1, third + 2);
  link(mesh, third + 1, first + 2);
  return {first, second, third};
}

// Splits the triangle at a hull edge u -> v, on which the point p lies.
void split_hull_edge(PointMesh& mesh, Hull& hull, const Index h, const Index p,
                     std::vector<Index>& across) {
  const Index u = mesh.from(h);
  const Index v = mesh.to(h);
  const Index next = PointMesh::next(h);
  const Index w = mesh.to(next);
  const Index beyond = mesh.opposite(next);
  replace_corner(mesh, next, p);  // (u, p, w) stays in the triangle's slots
  const Index added = add_triangle(mesh, p, v, w);
  link(mesh, added + 1, beyond);
  if (beyond == kNone) mesh.hull_edge[at(v)] = added + 1;
  link(mesh, next, added + 2);
  join(mesh, hull, u, p, h);
  join(mesh, hull, p, v, added);
  across.assign({added + 1, PointMesh::prev(h)});
}

// Adds the point p, wherever it lies.
void add_point(PointMesh& mesh, Hull& hull, const Index p, const Index near,
               std::vector<Index>& across) {
  const Place place = locate(mesh, near, p);
  if (place.region == Region::kOutside) return add_outside(mesh, hull, p, place.hull_point, across);
  const Index twin = mesh.opposite(place.half_edge);
  if (place.region == Region::kEdge && twin == kNone)
    return split_hull_edge(mesh, hull, place.half_edge, p, across);
  const std::array<Index, 3> sides = split_triangle(mesh, place.half_edge / 3, p);
  across.assign(sides.begin(), sides.end());
  if (place.region == Region::kTriangle) return;
  // One of the three is flat, on the edge: with the triangle beyond it becomes two that are not.
  const Index flat = sides[at(place.half_edge % 3)];
  const Index beyond = mesh.opposite(flat);
  flip(mesh, flat);
  across.push_back(PointMesh::prev(beyond));
}

}  // namespace

PointMesh triangulate_points(std::vector<Vec2> sorted_points) {
  PointMesh mesh;
  mesh.points = std::move(sorted_points);
  const auto n = static_cast<Index>(mesh.points.size());
  mesh.outgoing.assign(at(n), kNone);
  mesh.hull_edge.assign(at(n), kNone);
  Index apex = 2;
  while (apex < n && orient2d(mesh.point(0), mesh.point(1), mesh.point(apex)) == 0) ++apex;
  if (apex >= n) return mesh;
  mesh.origin.reserve(at(6 * n));
  mesh.twin.reserve(at(6 * n));
  mesh.fixed.reserve(at(6 * n));
  mesh.odd.reserve(at(6 * n));
  mesh.least_sine.reserve(at(2 * n));
  Hull hull = start_hull(mesh, apex);
  std::vector<Index> across;
  if (n <= kSweptPoints) {
    // Each point is beyond all before it: its predecessor is on the hull and sees it.
    for (Index p = apex + 1; p < n; ++p) {
      add_outside(mesh, hull, p, p - 1, across);
      improve_angles(mesh, across);
    }
    return mesh;
  }
  Index near = apex;
  for (const Index p : insertion_order(mesh.points, apex + 1)) {
    add_point(mesh, hull, p, near, across);
    improve_angles(mesh, across);
    near = p;
  }
  return mesh;
}

}  // namespace pdg
