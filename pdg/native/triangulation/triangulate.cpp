#include "triangulate.hpp"

#include <array>
#include <cstdint>
#include <numeric>
#include <optional>
#include <utility>

#include "edge_insertion.hpp"
#include "triangulate_points.hpp"
#include "triangulate_sweep.hpp"
#include "tuning.hpp"

namespace pdg {
namespace {

constexpr std::size_t at(const Index i) {
  return static_cast<std::size_t>(i);
}

// Per triangle: 1 inside, 0 outside, by the parity of constraints crossed from outside the hull.
std::vector<std::int8_t> inside_flags(const PointMesh& mesh) {
  std::vector<std::int8_t> inside(at(mesh.triangle_count()), -1);
  std::vector<Index> stack;
  const auto visit = [&](const Index triangle, const bool flag) {
    if (inside[at(triangle)] != -1) return;
    inside[at(triangle)] = flag ? 1 : 0;
    stack.push_back(triangle);
  };
  for (Index h = 0; h < 3 * mesh.triangle_count(); ++h) {
    if (mesh.opposite(h) == kNone) visit(h / 3, mesh.odd[at(h)] != 0);
  }
  while (!stack.empty()) {
    const Index triangle = stack.back();
    stack.pop_back();
    for (Index h = 3 * triangle; h < 3 * triangle + 3; ++h) {
      if (mesh.opposite(h) == kNone) continue;
      visit(mesh.opposite(h) / 3, (inside[at(triangle)] == 1) != (mesh.odd[at(h)] == 1));
    }
  }
  return inside;
}

Triangulation interior(const PointMesh& mesh) {
  const std::vector<std::int8_t> inside = inside_flags(mesh);
  std::vector<Index> renumbered(inside.size(), kNone);
  Index count = 0;
  for (std::size_t t = 0; t < inside.size(); ++t) {
    if (inside[t] == 1) renumbered[t] = count++;
  }
  Triangulation result;
  result.points = mesh.points;
  for (Index t = 0; t < mesh.triangle_count(); ++t) {
    if (inside[at(t)] != 1) continue;
    std::array<Index, 3> corners{};
    std::array<Index, 3> neighbours{};
    for (Index k = 0; k < 3; ++k) {
      const Index across = mesh.opposite(3 * t + k);
      corners[at(k)] = mesh.from(3 * t + k);
      neighbours[at(k)] = across == kNone ? kNone : renumbered[at(across / 3)];
    }
    result.triangles.push_back(corners);
    result.neighbours.push_back(neighbours);
  }
  return result;
}

// All points triangulated, then the edges put in: for any polygon.
PointMesh triangulate_constrained(const Polygon& polygon, const std::uint64_t most_steps) {
  PointMesh mesh = triangulate_points(distinct_points(polygon));
  mesh.most_steps = most_steps;
  if (mesh.triangle_count() == 0) return mesh;
  for (const Ring& ring : polygon.rings) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Vec2 next = ring[i + 1 == ring.size() ? 0 : i + 1];
      insert_constraint(mesh, index_of(mesh.points, ring[i]), index_of(mesh.points, next));
    }
  }
  return mesh;
}

// Nothing where that takes more than so many steps.
std::optional<PointMesh> triangulate_sparse(const Polygon& polygon, const std::uint64_t steps) {
  try {
    return triangulate_constrained(polygon, steps);
  } catch (const CrowdedError&) {
    return std::nullopt;
  }
}

// A mesh of the hull or, by a sweep, of the interior only. Where rings touch, a sweep gives up.
// Throws CrowdedError.
PointMesh make_mesh(const Polygon& polygon) {
  std::size_t count = 0;
  for (const Ring& ring : polygon.rings) count += ring.size();
  std::optional<PointMesh> mesh;
  if (count > kMostSweptVertices) mesh = triangulate_sparse(polygon, kStepsBeforeSweep);
  if (!mesh) mesh = triangulate_sweep(polygon);
  return mesh ? *std::move(mesh) : triangulate_constrained(polygon, kMostConstraintSteps);
}

}  // namespace

Triangulation triangulate(const Polygon& polygon) {
  PointMesh mesh = make_mesh(polygon);
  if (mesh.triangle_count() == 0) return {};
  std::vector<Index> all(mesh.origin.size());
  std::iota(all.begin(), all.end(), Index{0});
  const std::uint64_t most_flips = kMostFlips + kMostFlipsPerTriangle * at(mesh.triangle_count());
  improve_angles(mesh, all, most_flips);
  return interior(mesh);
}

}  // namespace pdg
