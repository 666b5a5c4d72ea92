#include "validity.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "decompose.hpp"
#include "pdg/native/triangulation/edge_insertion.hpp"
#include "pdg/native/triangulation/ring_sweep.hpp"
#include "pdg/native/triangulation/triangulate_points.hpp"

namespace pdg {
namespace {

constexpr std::size_t at(const Index i) {
  return static_cast<std::size_t>(i);
}

// Which ring has which vertex, sorted.
using Incidence = std::pair<Index, Index>;  // vertex, ring

// A piece of a ring's edge, from one vertex to the next on it.
struct Stretch {
  Index from, to;
  Index ring;
};

// The point where two edges cross, as well as doubles can tell.
Vec2 crossing_point(const EdgesCrossError& error) {
  const auto [p, q] = error.first;
  const auto [r, s] = error.second;
  const double t = cross(r - p, s - r) / cross(q - p, s - r);
  return t >= 0.0 && t <= 1.0 ? p + t * (q - p) : r;
}

std::vector<Incidence> incidences(const Polygon& polygon, const PointMesh& mesh) {
  std::vector<Incidence> found;
  for (std::size_t r = 0; r < polygon.rings.size(); ++r) {
    for (const Vec2 p : polygon.rings[r])
      found.emplace_back(index_of(mesh.points, p), static_cast<Index>(r));
  }
  std::sort(found.begin(), found.end());
  return found;
}

// Inserts all rings. A defect if one of them meets itself.
std::optional<Defect> insert_rings(const Polygon& polygon, const std::vector<Incidence>& vertices,
                                   PointMesh& mesh, std::vector<Stretch>& stretches) {
  std::optional<Defect> defect;
  for (std::size_t r = 0; r < polygon.rings.size(); ++r) {
    const Ring& ring = polygon.rings[r];
    const auto id = static_cast<Index>(r);
    for (std::size_t i = 0; i < ring.size() && !defect; ++i) {
      const Index v = index_of(mesh.points, ring[i + 1 == ring.size() ? 0 : i + 1]);
      const auto passed = [&](const Index from, const Index to) {
        stretches.push_back({from, to, id});
        if (to != v && std::binary_search(vertices.begin(), vertices.end(), Incidence{to, id}))
          defect = Defect{"ring self-intersection", mesh.point(to)};
      };
      insert_constraint(mesh, index_of(mesh.points, ring[i]), v, passed);
    }
  }
  return defect;
}

// Per half-edge the ring that runs along it, or kNone. A defect if it is two.
std::optional<Defect> assign_rings(const PointMesh& mesh, const std::vector<Stretch>& stretches,
                                   std::vector<Index>& ring_along) {
  ring_along.assign(mesh.origin.size(), kNone);
  for (const Stretch& s : stretches) {
    const Index h = find_edge(mesh, s.from, s.to);
    if (ring_along[at(h)] != kNone) return Defect{"self-intersection", mesh.point(s.from)};
    for (const Index e : {h, mesh.opposite(h)})
      if (e != kNone) ring_along[at(e)] = s.ring;
  }
  return std::nullopt;
}

// Where a triangle lies. Rings are closed and do not cross, so it is either on one side of a ring
// or on the other, by whichever way it is reached.
struct Side {
  bool visited = false;
  bool in_shell = false;
  Index hole = kNone;
};

// The side across an edge of a ring (or of none), or what is wrong with it.
const char* cross_ring(Side& side, const Index ring) {
  if (ring == kNone) return nullptr;
  if (ring == 0) {
    side.in_shell = !side.in_shell;
    return side.hole == kNone ? nullptr : "hole lies outside shell";
  }
  if (side.hole == ring) {
    side.hole = kNone;
    return nullptr;
  }
  if (side.hole != kNone) return "holes are nested";
  side.hole = ring;
  return side.in_shell ? nullptr : "hole lies outside shell";
}

// Finds the side of every triangle from outside the hull inwards. A defect if a hole is misplaced.
std::optional<Defect> find_sides(const PointMesh& mesh, const std::vector<Index>& ring_along,
                                 std::vector<Side>& sides) {
  sides.assign(at(mesh.triangle_count()), {});
  std::vector<Index> stack;
  std::optional<Defect> defect;
  const auto enter = [&](const Index h, const Side from) {  // the triangle of h, across h
    Side& side = sides[at(h / 3)];
    if (side.visited || defect) return;
    side = from;
    side.visited = true;
    if (const char* what = cross_ring(side, ring_along[at(h)]))
      defect = Defect{what, mesh.point(mesh.from(h))};
    stack.push_back(h / 3);
  };
  for (Index h = 0; h < 3 * mesh.triangle_count(); ++h)
    if (mesh.opposite(h) == kNone) enter(h, {});
  while (!stack.empty() && !defect) {
    const Index triangle = stack.back();
    stack.pop_back();
    for (Index h = 3 * triangle; h < 3 * triangle + 3; ++h)
      if (mesh.opposite(h) != kNone) enter(mesh.opposite(h), sides[at(triangle)]);
  }
  return defect;
}

// A defect if the interior falls into parts.
std::optional<Defect> find_parts(const PointMesh& mesh, const std::vector<Index>& ring_along,
                                 const std::vector<Side>& sides) {
  std::vector<std::uint8_t> reached(sides.size(), 0);
  std::vector<Index> stack;
  bool first = true;
  for (Index t = 0; t < mesh.triangle_count(); ++t) {
    const bool inside = sides[at(t)].in_shell && sides[at(t)].hole == kNone;
    if (!inside || reached[at(t)] != 0) continue;
    if (!std::exchange(first, false))
      return Defect{"interior is disconnected", mesh.point(mesh.from(3 * t))};
    reached[at(t)] = 1;
    stack.push_back(t);
    while (!stack.empty()) {
      const Index triangle = stack.back();
      stack.pop_back();
      for (Index h = 3 * triangle; h < 3 * triangle + 3; ++h) {
        if (ring_along[at(h)] != kNone) continue;
        const Index next = mesh.opposite(h) / 3;  // an edge of the hull is a ring's
        if (reached[at(next)] == 0) stack.push_back(next);
        reached[at(next)] = 1;
      }
    }
  }
  if (first) return Defect{"interior is empty", mesh.points.front()};
  return std::nullopt;
}

// The interior for RingSweep: where each ring begins, the shell must be around it and no hole.
class Nesting {
 public:
  Nesting(const SweepVertices& vertices, const std::size_t rings)
      : vertices_(vertices), begun_(rings, false), odd_(rings) {}

  void watch(const RingSweep<Nesting>& sweep) { sweep_ = &sweep; }

  Index open(const Index v) {
    begin(v, 0, false);
    return 0;
  }
  Index split(const Index v, Index, const std::size_t place) {
    begin(v, place, true);
    return 0;
  }
  void lower(Index, Index) {}
  void upper(Index, Index) {}
  bool close(Index, Index) { return right_; }
  void merge(Index, Index, Index) {}

 private:
  // By the even-odd rule the interior begins outside of all rings or within two; a hole begins
  // inside, below it an odd number of the shell's edges and an even number of every other ring's.
  void begin(const Index v, const std::size_t place, const bool inside) {
    const Index ring = vertices_.rings[at(v)];
    if (begun_[at(ring)]) return;
    begun_[at(ring)] = true;
    if (inside == (ring == 0)) right_ = false;
    if (!inside || !right_) return;
    odd_.assign(odd_.size(), false);
    for (std::size_t i = 0; i < place; ++i)
      odd_[at(vertices_.rings[at(sweep_->active()[i].left)])].flip();
    right_ = odd_[0] && std::count(odd_.begin(), odd_.end(), true) == 1;
  }

  const SweepVertices& vertices_;
  const RingSweep<Nesting>* sweep_ = nullptr;
  std::vector<bool> begun_, odd_;  // by ring
  bool right_ = true;
};

// Whether it is valid and nothing touches. False proves nothing.
bool plainly_valid(const Polygon& polygon) {
  const SweepVertices vertices = sort_vertices(polygon);
  if (vertices.points.empty()) return false;
  Nesting nesting(vertices, polygon.rings.size());
  RingSweep sweep(vertices, nesting);
  nesting.watch(sweep);
  return sweep.run();
}

}  // namespace

std::optional<Defect> find_defect(const Polygon& polygon) {
  if (polygon.rings.size() == 1 && !as_convex(polygon.rings.front()).empty()) return std::nullopt;
  if (plainly_valid(polygon)) return std::nullopt;
  PointMesh mesh = triangulate_points(distinct_points(polygon));
  if (mesh.triangle_count() == 0) return Defect{"interior is empty", mesh.points.front()};
  const std::vector<Incidence> vertices = incidences(polygon, mesh);
  const auto twice = std::adjacent_find(vertices.begin(), vertices.end());
  if (twice != vertices.end()) return Defect{"ring self-intersection", mesh.point(twice->first)};
  std::vector<Stretch> stretches;
  try {
    if (auto defect = insert_rings(polygon, vertices, mesh, stretches)) return defect;
  } catch (const EdgesCrossError& error) {
    return Defect{"self-intersection", crossing_point(error)};
  }
  std::vector<Index> ring_along;
  std::vector<Side> sides;
  if (auto defect = assign_rings(mesh, stretches, ring_along)) return defect;
  if (auto defect = find_sides(mesh, ring_along, sides)) return defect;
  return find_parts(mesh, ring_along, sides);
}

}  // namespace pdg
