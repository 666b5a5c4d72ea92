#include "edge_insertion.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdio>
#include <stdexcept>
#include <string>

#include "pdg/native/geometry/predicates.hpp"

namespace pdg {
namespace {

constexpr std::size_t at(const Index i) {
  return static_cast<std::size_t>(i);
}

std::string text(const Vec2 p) {
  char buffer[64];
  std::snprintf(buffer, sizeof buffer, "(%.17g, %.17g)", p.x, p.y);
  return buffer;
}

std::string text(const std::array<Vec2, 2>& edge) {
  return text(edge[0]) + " - " + text(edge[1]);
}

void spend(PointMesh& mesh, const std::size_t steps) {
  mesh.steps += steps;
  if (mesh.steps > mesh.most_steps) throw CrowdedError();
}

// One crossing edge of a segment under insertion.
struct Crossing {
  Index right;  // its end strictly right of the segment
  Index left;   // its end strictly left of it
};

// What lies between u and the next vertex on the segment u -> v.
struct Stretch {
  Index end = kNone;                // that vertex (v itself at the latest)
  std::vector<Crossing> crossings;  // edges crossed on the way, in order; none if the edge exists
};

// Walks through the triangles from u towards v until it meets a vertex.
Stretch walk(const PointMesh& mesh, const Index u, const Index v) {
  const Vec2 pu = mesh.point(u);
  const Vec2 pv = mesh.point(v);
  const auto side = [&](const Index w) { return orient2d(pu, pv, mesh.point(w)); };
  const auto ahead = [&](const Index w) {
    return lexicographically_less(pu, mesh.point(w)) == lexicographically_less(pu, pv);
  };
  Stretch stretch;
  const Index start = first_outgoing(mesh, u);
  Index crossed = kNone;  // half-edge from the right of the segment to its left
  Index h = start;
  do {
    const Index a = mesh.to(h);
    const Index b = mesh.from(PointMesh::prev(h));
    const int side_a = side(a);
    const int side_b = side(b);
    if (side_a == 0 && ahead(a)) stretch.end = a;
    if (side_b == 0 && ahead(b)) stretch.end = b;
    if (stretch.end != kNone) return stretch;
    if (side_a < 0 && side_b > 0) crossed = PointMesh::next(h);
    h = rotate_ccw(mesh, h);
  } while (crossed == kNone && h != kNone && h != start);
  while (stretch.end == kNone) {
    if (crossed == kNone) throw std::logic_error("triangulate: walk left the hull");
    if (mesh.fixed[at(crossed)] != 0)
      throw EdgesCrossError({pu, pv},
                            {mesh.point(mesh.from(crossed)), mesh.point(mesh.to(crossed))});
    stretch.crossings.push_back({mesh.from(crossed), mesh.to(crossed)});
    const Index inner = mesh.opposite(crossed);
    if (inner == kNone) throw std::logic_error("triangulate: walk left the hull");
    const Index apex = mesh.from(PointMesh::prev(inner));
    const int s = side(apex);
    if (s == 0) stretch.end = apex;
    crossed = s < 0 ? PointMesh::prev(inner) : PointMesh::next(inner);
  }
  return stretch;
}

// Takes one vertex off the right-hand side of the stretch u -> end, by flips.
//
// The vertices right of the segment form a chain u, a_1, ..., a_m, end that bounds, with the
// segment, a (weakly simple) polygon; it has an ear, so some a = a_i is a strict left turn. While
// a has crossing edges to b_1, ..., b_k, the b_j farthest from the line a_{i-1} a_{i+1} is a
// strictly convex corner of a's fan and so is a itself: that edge can be flipped away from a. After
// k flips the chain skips a, so the process ends with no vertex on the right and no crossing.
void clear_one_vertex(PointMesh& mesh, const Index u, const Stretch& stretch) {
  const std::vector<Crossing>& list = stretch.crossings;
  std::size_t begin = 0;
  Index before = u;
  while (begin < list.size()) {
    const Index a = list[begin].right;
    std::size_t end = begin;
    while (end < list.size() && list[end].right == a) ++end;
    const Index after = end < list.size() ? list[end].right : stretch.end;
    if (orient2d(mesh.point(before), mesh.point(a), mesh.point(after)) > 0) {
      std::vector<Index> fan;
      for (std::size_t i = begin; i < end; ++i) fan.push_back(list[i].left);
      while (!fan.empty()) {
        const auto found = std::find_if(fan.begin(), fan.end(), [&](const Index b) {
          spend(mesh, fan.size());  // find_edge goes round a
          return can_flip(mesh, find_edge(mesh, a, b));
        });
        if (found == fan.end()) throw std::logic_error("triangulate: no edge to flip");
        flip(mesh, find_edge(mesh, a, *found));
        fan.erase(found);
      }
      return;
    }
    before = a;
    begin = end;
  }
  throw std::logic_error("triangulate: no ear");
}

}  // namespace

CrowdedError::CrowdedError()
    : std::invalid_argument("too many long edges between crowded vertices") {}

EdgesCrossError::EdgesCrossError(const std::array<Vec2, 2>& e, const std::array<Vec2, 2>& f)
    : std::invalid_argument("edges cross: " + text(e) + " and " + text(f)), first(e), second(f) {}

std::vector<Vec2> distinct_points(const Polygon& polygon) {
  std::vector<Vec2> points;
  for (const Ring& ring : polygon.rings) {
    if (ring.size() < 3) throw std::invalid_argument("ring with fewer than three vertices");
    for (const Vec2 p : ring) {
      if (!in_exact_range(p)) {
        throw std::invalid_argument("coordinate outside the range of exact arithmetic at " +
                                    text(p));
      }
      points.push_back({p.x + 0.0, p.y + 0.0});  // -0 and 0 are the same point
    }
  }
  std::sort(points.begin(), points.end(), lexicographically_less);
  points.erase(std::unique(points.begin(), points.end()), points.end());
  return points;
}

Index index_of(const std::vector<Vec2>& points, const Vec2 p) {
  const auto found = std::lower_bound(points.begin(), points.end(), p, lexicographically_less);
  return static_cast<Index>(found - points.begin());
}

void insert_constraint(PointMesh& mesh, Index u, const Index v,
                       const std::function<void(Index, Index)>& passed) {
  while (u != v) {
    Stretch stretch = walk(mesh, u, v);
    while (!stretch.crossings.empty()) {
      spend(mesh, stretch.crossings.size());
      clear_one_vertex(mesh, u, stretch);
      stretch = walk(mesh, u, stretch.end);
    }
    const Index h = find_edge(mesh, u, stretch.end);
    for (const Index e : {h, mesh.opposite(h)}) {
      if (e == kNone) continue;
      mesh.fixed[at(e)] = 1;
      mesh.odd[at(e)] = mesh.odd[at(e)] == 0 ? 1 : 0;
    }
    if (passed) passed(u, stretch.end);
    u = stretch.end;
  }
}

}  // namespace pdg
