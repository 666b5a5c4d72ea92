#include "point_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "predicates.hpp"

namespace pdg {
namespace {

constexpr std::size_t at(const Index i) {
  return static_cast<std::size_t>(i);
}

void link(PointMesh& mesh, const Index a, const Index b) {
  mesh.twin[at(a)] = b;
  if (b != kNone) mesh.twin[at(b)] = a;
}

// Appends the counter-clockwise triangle (a, b, c) and returns its half-edge a -> b.
Index add_triangle(PointMesh& mesh, const Index a, const Index b, const Index c) {
  const auto h = static_cast<Index>(mesh.origin.size());
  mesh.origin.insert(mesh.origin.end(), {a, b, c});
  mesh.twin.insert(mesh.twin.end(), {kNone, kNone, kNone});
  mesh.fixed.insert(mesh.fixed.end(), {0, 0, 0});
  mesh.odd.insert(mesh.odd.end(), {0, 0, 0});
  mesh.outgoing[at(a)] = h;
  mesh.outgoing[at(b)] = h + 1;
  mesh.outgoing[at(c)] = h + 2;
  return h;
}

// Sine of the least angle of a triangle, in plain doubles; 0 for a degenerate result. The points
// are taken in increasing order, so a triangle always gets one and the same value.
double angle_measure(const PointMesh& mesh, Index a, Index b, Index c) {
  if (a > b) std::swap(a, b);
  if (b > c) std::swap(b, c);
  if (a > b) std::swap(a, b);
  const Vec2 p = mesh.point(a);
  const Vec2 q = mesh.point(b);
  const Vec2 r = mesh.point(c);
  const double pq = norm(q - p);
  const double qr = norm(r - q);
  const double rp = norm(p - r);
  // The least angle lies between the two longer sides.
  const double product = std::max({pq * qr, qr * rp, rp * pq});
  const double sine = std::abs(cross(q - p, r - p)) / product;
  return sine > 0.0 ? sine : 0.0;
}

// Lexicographic sweep: the state of the hull, counter-clockwise.
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

// Adds the point p, lexicographically greater than all before; its predecessor is on the hull and
// sees p, and so does one of the hull edges there.
std::vector<Index> add_point(PointMesh& mesh, Hull& hull, const Index p) {
  std::vector<Index> created;
  const auto visible = [&](const Index a, const Index b) {
    return orient2d(mesh.point(a), mesh.point(b), mesh.point(p)) < 0;
  };
  const Index start = p - 1;
  Index after = start;          // end of the visible chain, counter-clockwise
  Index edge_to_after = kNone;  // half-edge p -> after
  while (visible(after, hull.next[at(after)])) {
    const Index n = hull.next[at(after)];
    const Index h = cover_hull_edge(mesh, after, n, p);
    if (edge_to_after != kNone) link(mesh, h + 1, edge_to_after);
    edge_to_after = h + 2;
    created.push_back(h);
    after = n;
  }
  Index before = start;
  Index edge_from_before = created.empty() ? kNone : created.front() + 1;  // before -> p
  while (visible(hull.prev[at(before)], before)) {
    const Index v = hull.prev[at(before)];
    const Index h = cover_hull_edge(mesh, v, before, p);
    if (edge_from_before != kNone) {
      link(mesh, h + 2, edge_from_before);
    } else {
      edge_to_after = h + 2;
    }
    edge_from_before = h + 1;
    created.push_back(h);
    before = v;
  }
  join(mesh, hull, before, p, edge_from_before);
  join(mesh, hull, p, after, edge_to_after);
  return created;
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
  Hull hull = start_hull(mesh, apex);
  for (Index p = apex + 1; p < n; ++p) improve_angles(mesh, add_point(mesh, hull, p));
  return mesh;
}

Index rotate_ccw(const PointMesh& mesh, const Index h) {
  return mesh.opposite(PointMesh::prev(h));
}

Index first_outgoing(const PointMesh& mesh, const Index v) {
  const Index start = mesh.outgoing[at(v)];
  Index h = start;
  while (mesh.opposite(h) != kNone) {
    h = PointMesh::next(mesh.opposite(h));
    if (h == start) break;
  }
  return h;
}

Index find_edge(const PointMesh& mesh, const Index a, const Index b) {
  const Index start = first_outgoing(mesh, a);
  Index h = start;
  do {
    if (mesh.to(h) == b) return h;
    const Index incoming = PointMesh::prev(h);
    if (mesh.from(incoming) == b) {
      return mesh.opposite(incoming) == kNone ? incoming : mesh.opposite(incoming);
    }
    h = rotate_ccw(mesh, h);
  } while (h != kNone && h != start);
  return kNone;
}

bool can_flip(const PointMesh& mesh, const Index h) {
  const Index t = mesh.opposite(h);
  if (t == kNone || mesh.fixed[at(h)] != 0) return false;
  const Vec2 u = mesh.point(mesh.from(h));
  const Vec2 v = mesh.point(mesh.to(h));
  const Vec2 w = mesh.point(mesh.from(PointMesh::prev(h)));
  const Vec2 x = mesh.point(mesh.from(PointMesh::prev(t)));
  return orient2d(u, x, w) > 0 && orient2d(x, v, w) > 0;
}

// With h = u -> v in (u, v, w) and its twin t in (v, u, x): the result is (u, x, w) and (x, v, w).
// Slot h takes the outer edge u -> x, slot t the outer edge v -> w; the slots after them hold the
// new diagonal.
void flip(PointMesh& mesh, const Index h) {
  const Index t = mesh.opposite(h);
  const Index hn = PointMesh::next(h);
  const Index tn = PointMesh::next(t);
  const Index u = mesh.from(h);
  const Index v = mesh.from(t);
  const Index w = mesh.from(PointMesh::prev(h));
  const Index x = mesh.from(PointMesh::prev(t));
  const auto move_outer = [&](const Index slot, const Index old) {
    link(mesh, slot, mesh.opposite(old));
    mesh.fixed[at(slot)] = mesh.fixed[at(old)];
    mesh.odd[at(slot)] = mesh.odd[at(old)];
    if (mesh.opposite(slot) == kNone) mesh.hull_edge[at(mesh.from(slot))] = slot;
  };
  move_outer(h, tn);
  move_outer(t, hn);
  mesh.origin[at(hn)] = x;
  mesh.origin[at(tn)] = w;
  link(mesh, hn, tn);
  for (const Index d : {hn, tn}) {
    mesh.fixed[at(d)] = 0;
    mesh.odd[at(d)] = 0;
  }
  mesh.outgoing[at(u)] = h;
  mesh.outgoing[at(v)] = t;
}

// Each triangle has one fixed computed measure. A flip replaces two triangles by two whose lesser
// measure is strictly greater, so the sorted list of all measures grows lexicographically with
// every flip, whatever the rounding: no triangulation comes twice, and there are finitely many.
// (In exact arithmetic the result is the constrained Delaunay triangulation.)
void improve_angles(PointMesh& mesh, std::vector<Index> half_edges) {
  while (!half_edges.empty()) {
    const Index h = half_edges.back();
    half_edges.pop_back();
    if (!can_flip(mesh, h)) continue;
    const Index t = mesh.opposite(h);
    const Index u = mesh.from(h);
    const Index v = mesh.from(t);
    const Index w = mesh.from(PointMesh::prev(h));
    const Index x = mesh.from(PointMesh::prev(t));
    const double now = std::min(angle_measure(mesh, u, v, w), angle_measure(mesh, v, u, x));
    const double flipped = std::min(angle_measure(mesh, u, x, w), angle_measure(mesh, x, v, w));
    if (!(flipped > now)) continue;
    flip(mesh, h);
    const Index outer[] = {h, PointMesh::prev(h), t, PointMesh::prev(t)};
    half_edges.insert(half_edges.end(), std::begin(outer), std::end(outer));
  }
}

}  // namespace pdg
