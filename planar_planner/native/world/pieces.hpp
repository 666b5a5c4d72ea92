// Polygons as the convex pieces that the planner works on.
#pragma once

#include <cstddef>
#include <vector>

#include "pdg/native/geometry/polygon.hpp"

namespace planner {

// A pair's axes and vertices are counted in 16 bits: two pieces of this size still fit.
inline constexpr std::size_t kMaxPieceVertices = 32767;

// An exact convex partition with the polygon's own vertices. A partition, not a cover of
// overlapping pieces: a cover culls hardly more cells, at several times the axis evaluations
// (docs/method.md). Larger convex pieces are cut into fans.
// `partition` false: the cover, for that comparison.
std::vector<pdg::ConvexPolygon> planner_pieces(const pdg::Polygon& polygon, bool partition = true);

}  // namespace planner
