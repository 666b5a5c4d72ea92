// Triangulate, merge triangles into convex parts (Hertel and Mehlhorn), grow the parts to a cover.
//
// Parts are rings of point indices, counter-clockwise and weakly convex: collinear vertices stay in
// until the end, so that neighbouring parts share whole edges.
#include "decompose.hpp"

#include <algorithm>
#include <cstdint>
#include <stdexcept>
#include <tuple>
#include <utility>

#include "cover.hpp"
#include "pdg/native/geometry/predicates.hpp"
#include "pdg/native/triangulation/triangulate.hpp"
#include "tuning.hpp"

namespace pdg {
namespace {

constexpr std::size_t at(const Index i) {
  return static_cast<std::size_t>(i);
}

// Whether q goes straight on from p -> u (exactly).
bool goes_straight(const Vec2 p, const Vec2 u, const Vec2 q) {
  return orient2d(p, u, q) == 0 && passes_through(p, u, q);
}

ConvexPolygon without_collinear(const Ring& ring) {
  ConvexPolygon kept;
  const std::size_t n = ring.size();
  for (std::size_t i = 0; i < n; ++i) {
    if (!goes_straight(ring[(i + n - 1) % n], ring[i], ring[(i + 1) % n])) kept.push_back(ring[i]);
  }
  return kept;
}

// Rings of a half-edge structure over the interior triangles: half-edge 3t + k is edge k of
// triangle t until merging relinks it.
struct PartRings {
  std::vector<Index> origin;
  std::vector<Index> twin;
  std::vector<Index> next;
  std::vector<Index> prev;
};

PartRings rings_of_triangles(const Triangulation& triangulation) {
  const std::size_t n = 3 * triangulation.triangles.size();
  PartRings rings{std::vector<Index>(n), std::vector<Index>(n, kNone), std::vector<Index>(n),
                  std::vector<Index>(n)};
  for (std::size_t t = 0; t < triangulation.triangles.size(); ++t) {
    for (std::size_t k = 0; k < 3; ++k) {
      const auto h = static_cast<Index>(3 * t + k);
      rings.origin[at(h)] = triangulation.triangles[t][k];
      rings.next[at(h)] = PointMesh::next(h);
      rings.prev[at(h)] = PointMesh::prev(h);
      const Index across = triangulation.neighbours[t][k];
      if (across == kNone) continue;
      // The shared edge runs the other way round in the neighbour: it starts where edge k ends.
      const auto& corners = triangulation.triangles[at(across)];
      const Index start = triangulation.triangles[t][(k + 1) % 3];
      for (Index j = 0; j < 3; ++j) {
        if (corners[at(j)] == start) rings.twin[at(h)] = 3 * across + j;
      }
    }
  }
  return rings;
}

// Whether the parts on both sides of h stay convex when h is taken out.
bool can_merge(const PartRings& r, const std::vector<Vec2>& points, const Index h) {
  const Index t = r.twin[at(h)];
  const auto origin = [&](const Index e) { return points[at(r.origin[at(e)])]; };
  const auto end = [&](const Index e) { return origin(r.next[at(e)]); };
  return turns_left_or_straight(origin(r.prev[at(h)]), origin(h), end(r.next[at(t)])) &&
         turns_left_or_straight(origin(r.prev[at(t)]), origin(t), end(r.next[at(h)]));
}

void merge(PartRings& r, const Index h) {
  const Index t = r.twin[at(h)];
  const auto join = [&](const Index a, const Index b) {
    r.next[at(a)] = b;
    r.prev[at(b)] = a;
  };
  join(r.prev[at(h)], r.next[at(t)]);
  join(r.prev[at(t)], r.next[at(h)]);
  for (const Index e : {h, t}) r.next[at(e)] = kNone;
}

// A fixed factor in [0.5, 1) for the diagonal of two points, different in every order but the
// first, where it is 1 (a SplitMix64 step).
double order_factor(const std::uint64_t order, const Index a, const Index b) {
  if (order == 0) return 1.0;
  std::uint64_t z =
      (order << 58U) ^ (static_cast<std::uint64_t>(a) << 29U) ^ static_cast<std::uint64_t>(b);
  z = (z + 0x9e3779b97f4a7c15U) * 0xbf58476d1ce4e5b9U;
  z = (z ^ (z >> 27U)) * 0x94d049bb133111ebU;
  return 0.5 + static_cast<double>(z >> 11U) * 0x1p-54;
}

struct Diagonal {
  double length;  // weighted by order_factor
  Index a, b;     // its points, a < b
  Index half_edge;
};

std::vector<Diagonal> diagonals_of(const PartRings& rings) {
  std::vector<Diagonal> diagonals;
  for (Index h = 0; h < static_cast<Index>(rings.origin.size()); ++h) {
    if (rings.twin[at(h)] <= h) continue;
    const Index u = rings.origin[at(h)];
    const Index v = rings.origin[at(rings.twin[at(h)])];
    diagonals.push_back({0.0, std::min(u, v), std::max(u, v), h});
  }
  return diagonals;
}

// Hertel-Mehlhorn, longest diagonals first: short cuts (the base of a tooth) stay, wide-open
// regions become one part. The lengths only set the order; every decision is exact. Returns how
// many diagonals went.
std::size_t merge_parts(PartRings& rings, const std::vector<Vec2>& points,
                        std::vector<Diagonal> diagonals, const std::uint64_t order) {
  for (Diagonal& d : diagonals) {
    d.length = norm(points[at(d.b)] - points[at(d.a)]) * order_factor(order, d.a, d.b);
  }
  std::sort(diagonals.begin(), diagonals.end(), [](const Diagonal& d, const Diagonal& e) {
    return std::tie(e.length, d.a, d.b) < std::tie(d.length, e.a, e.b);
  });
  std::size_t merged = 0;
  for (const Diagonal& d : diagonals) {
    if (!can_merge(rings, points, d.half_edge)) continue;
    merge(rings, d.half_edge);
    ++merged;
  }
  return merged;
}

// Corners of the boundary where the interior angle exceeds pi; each needs a diagonal.
std::size_t reflex_count(const PartRings& rings, const std::vector<Vec2>& points) {
  std::size_t count = 0;
  for (Index h = 0; h < static_cast<Index>(rings.origin.size()); ++h) {
    if (rings.twin[at(h)] != kNone) continue;
    // From the boundary edge h -> v rotate about v to the boundary edge that leaves v.
    Index out = rings.next[at(h)];
    while (rings.twin[at(out)] != kNone) out = rings.next[at(rings.twin[at(out)])];
    const Vec2 p = points[at(rings.origin[at(h)])];
    const Vec2 u = points[at(rings.origin[at(out)])];
    const Vec2 q = points[at(rings.origin[at(rings.next[at(out)])])];
    if (!turns_left_or_straight(p, u, q)) ++count;
  }
  return count;
}

// The best of several orders. One diagonal resolves at most two reflex vertices, so at least half
// their number must stay.
PartRings merged_parts(const Triangulation& triangulation) {
  const PartRings triangles = rings_of_triangles(triangulation);
  const std::vector<Diagonal> diagonals = diagonals_of(triangles);
  const std::size_t must_stay = (reflex_count(triangles, triangulation.points) + 1) / 2;
  PartRings best, rings;
  std::size_t most = 0;
  const std::uint64_t orders = diagonals.size() <= kMostDiagonalsOfOrders ? kMergeOrders : 1;
  for (std::uint64_t order = 0; order < orders; ++order) {
    rings = triangles;
    const std::size_t merged = merge_parts(rings, triangulation.points, diagonals, order);
    if (order == 0 || merged > most) {
      most = merged;
      std::swap(best, rings);
    }
    if (most + must_stay >= diagonals.size()) break;
  }
  return best;
}

std::vector<Part> partition(const Triangulation& triangulation) {
  const PartRings rings = merged_parts(triangulation);
  std::vector<Part> parts;
  std::vector<std::uint8_t> seen(rings.origin.size(), 0);
  for (Index start = 0; start < static_cast<Index>(rings.origin.size()); ++start) {
    if (rings.next[at(start)] == kNone || seen[at(start)] != 0) continue;
    Part part;
    for (Index h = start; seen[at(h)] == 0; h = rings.next[at(h)]) {
      seen[at(h)] = 1;
      part.push_back(rings.origin[at(h)]);
    }
    parts.push_back(std::move(part));
  }
  return parts;
}

// Coordinates instead of indices, starting at the lexicographically least vertex.
ConvexPolygon as_polygon(const std::vector<Vec2>& points, const Part& part) {
  Ring ring;
  const auto least = std::min_element(part.begin(), part.end());
  for (auto i = least; i != part.end(); ++i) ring.push_back(points[at(*i)]);
  for (auto i = part.begin(); i != least; ++i) ring.push_back(points[at(*i)]);
  return without_collinear(ring);
}

enum class Growth : std::uint8_t { kNone, kCover };

std::vector<ConvexPolygon> decompose(const Polygon& polygon, const Growth growth) {
  if (polygon.rings.empty()) throw std::invalid_argument("polygon without rings");
  if (polygon.rings.size() == 1) {
    ConvexPolygon whole = as_convex(polygon.rings.front());
    if (!whole.empty()) return {std::move(whole)};
  }
  const Triangulation triangulation = triangulate(polygon);
  std::vector<Part> parts = partition(triangulation);
  if (growth == Growth::kCover) parts = grow_to_cover(triangulation.points, parts);
  std::vector<ConvexPolygon> pieces;
  pieces.reserve(parts.size());
  for (const Part& part : parts) pieces.push_back(as_polygon(triangulation.points, part));
  return pieces;
}

}  // namespace

std::vector<ConvexPolygon> convex_pieces(const Polygon& polygon) {
  return decompose(polygon, Growth::kCover);
}

std::vector<ConvexPolygon> convex_partition(const Polygon& polygon) {
  return decompose(polygon, Growth::kNone);
}

// A ring is convex when it turns only one way and passes through once: its edges change their
// lexicographic direction exactly twice. A ring that goes back on itself is not.
ConvexPolygon as_convex(const Ring& ring) {
  const std::size_t n = ring.size();
  int turn = 0;
  int direction_changes = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const Vec2 p = ring[(i + n - 1) % n];
    const Vec2 u = ring[i];
    const Vec2 q = ring[(i + 1) % n];
    if (!in_exact_range(u) || p == u) return {};
    const int side = orient2d(p, u, q);
    if (side == 0 && !passes_through(p, u, q)) return {};
    if (side != 0 && turn != 0 && side != turn) return {};
    if (side != 0) turn = side;
    if (!passes_through(p, u, q)) ++direction_changes;
  }
  if (turn == 0 || direction_changes != 2) return {};
  ConvexPolygon polygon = without_collinear(ring);
  if (turn < 0) std::reverse(polygon.begin(), polygon.end());
  return polygon;
}

}  // namespace pdg
