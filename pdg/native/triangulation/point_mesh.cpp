#include "point_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

#include "pdg/native/geometry/predicates.hpp"

namespace pdg {
namespace {

constexpr std::size_t at(const Index i) {
  return static_cast<std::size_t>(i);
}

// Sine of the least angle of a triangle, in plain doubles; 0 for a degenerate result. The points
// are taken in increasing order, so a triangle always gets one and the same value.
double least_sine(const PointMesh& mesh, Index a, Index b, Index c) {
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

double measure(PointMesh& mesh, const Index triangle) {
  double& known = mesh.least_sine[at(triangle)];
  if (known == kUnmeasured) {
    const Index h = 3 * triangle;
    known = least_sine(mesh, mesh.from(h), mesh.from(h + 1), mesh.from(h + 2));
  }
  return known;
}

}  // namespace

void link(PointMesh& mesh, const Index a, const Index b) {
  mesh.twin[at(a)] = b;
  if (b != kNone) mesh.twin[at(b)] = a;
}

Index add_triangle(PointMesh& mesh, const Index a, const Index b, const Index c) {
  const auto h = static_cast<Index>(mesh.origin.size());
  mesh.origin.insert(mesh.origin.end(), {a, b, c});
  mesh.twin.insert(mesh.twin.end(), {kNone, kNone, kNone});
  mesh.fixed.insert(mesh.fixed.end(), {0, 0, 0});
  mesh.odd.insert(mesh.odd.end(), {0, 0, 0});
  mesh.least_sine.push_back(kUnmeasured);
  mesh.outgoing[at(a)] = h;
  mesh.outgoing[at(b)] = h + 1;
  mesh.outgoing[at(c)] = h + 2;
  return h;
}

void replace_corner(PointMesh& mesh, const Index h, const Index v) {
  mesh.origin[at(h)] = v;
  mesh.least_sine[at(h / 3)] = kUnmeasured;
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
  replace_corner(mesh, hn, x);
  replace_corner(mesh, tn, w);
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
void improve_angles(PointMesh& mesh, std::vector<Index>& half_edges,
                    const std::uint64_t most_flips) {
  std::uint64_t flips = 0;
  while (!half_edges.empty() && flips < most_flips) {
    const Index h = half_edges.back();
    half_edges.pop_back();
    if (!can_flip(mesh, h)) continue;
    const Index t = mesh.opposite(h);
    const Index u = mesh.from(h);
    const Index v = mesh.from(t);
    const Index w = mesh.from(PointMesh::prev(h));
    const Index x = mesh.from(PointMesh::prev(t));
    const double now = std::min(measure(mesh, h / 3), measure(mesh, t / 3));
    const double first = least_sine(mesh, u, x, w);
    if (!(first > now)) continue;
    const double second = least_sine(mesh, x, v, w);
    if (!(second > now)) continue;
    flip(mesh, h);
    ++flips;
    mesh.least_sine[at(h / 3)] = first;
    mesh.least_sine[at(t / 3)] = second;
    const Index outer[] = {h, PointMesh::prev(h), t, PointMesh::prev(t)};
    half_edges.insert(half_edges.end(), std::begin(outer), std::end(outer));
  }
}

}  // namespace pdg
