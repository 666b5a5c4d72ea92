// A way between two points of a layer. A shortest way in a closed polygonal set bends only at
// corners of what it goes round: at vertices of the open sums. (Where no vertex lies, the free set
// is an intersection of closed half-planes near the point, and the bend can be cut off.) So the
// ways along free vertices are complete, points of contact and slits of no width included.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "layer.hpp"

namespace planner {

// Start, corners, goal: lattice points whose coordinates are doubles, joined by free segments.
// Empty: none was found, because a corner that is needed is no double or the work got too much.
std::optional<std::vector<LatticePoint>> find_taut_path(const Layer& layer);

// A way from the start to a place of the layer's region. Empty: none was found; a place of it that
// no corner, vertex of the region or move along an axis reaches is not.
std::optional<std::vector<LatticePoint>> find_way_into_region(const Layer& layer);

// A free place of the region among the corners and its vertices, if there is one.
std::optional<LatticePoint> free_place_in_region(const Layer& layer);

// A way from the start to a place that `is_open` accepts, one of `lengths` away from the last
// corner in one of eight directions; of the nearer corners first. Empty: none was found near the
// start.
using OpenTest = std::function<bool(LatticePoint)>;
std::optional<std::vector<LatticePoint>> find_way_out(const Layer& layer,
                                                      std::span<const Int64> lengths,
                                                      const OpenTest& is_open);

}  // namespace planner
