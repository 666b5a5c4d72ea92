// A polygon's edges as constraints of a triangulation of its vertices. Exact.
#pragma once

#include <array>
#include <functional>
#include <stdexcept>
#include <vector>

#include "pdg/native/geometry/polygon.hpp"
#include "point_mesh.hpp"

namespace pdg {

// Two edges have one point in common, inside both.
struct EdgesCrossError : std::invalid_argument {
  EdgesCrossError(const std::array<Vec2, 2>& e, const std::array<Vec2, 2>& f);
  std::array<Vec2, 2> first;
  std::array<Vec2, 2> second;
};

// Constraints cross so many edges that making room for them takes more than mesh.most_steps.
struct CrowdedError : std::invalid_argument {
  CrowdedError();
};

// The vertices of all rings, sorted lexicographically, each once. Throws std::invalid_argument on a
// ring of fewer than three and on coordinates outside the range of exact arithmetic.
std::vector<Vec2> distinct_points(const Polygon& polygon);

// The place of a vertex among them.
Index index_of(const std::vector<Vec2>& points, Vec2 p);

// Makes u -> v an edge, or a chain of edges if it runs through other vertices, and fixes it.
// `passed` is called with both ends of every edge of the chain, in order. Throws EdgesCrossError
// and CrowdedError.
void insert_constraint(PointMesh& mesh, Index u, Index v,
                       const std::function<void(Index, Index)>& passed = {});

}  // namespace pdg
