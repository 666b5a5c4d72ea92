// Heuristic constants of this folder, with how each was found. They steer work; whatever their
// values, pieces are convex and cover the polygon.
#pragma once

#include <cstddef>
#include <cstdint>

namespace pdg {

// Orders of merging that are tried; the first that reaches the lower bound of parts ends it. They
// spare a tenth of the parts of polygons with a dozen vertices, and a hundredth of a hundred's:
// those of more diagonals than this are merged once. Measured.
inline constexpr std::size_t kMostDiagonalsOfOrders = 40;
inline constexpr std::uint64_t kMergeOrders = 6;

}  // namespace pdg
