// A way between two points of a layer. A shortest way in a closed polygonal set bends only at
// corners of what it goes round: at vertices of the open sums. (Where no vertex lies, the free set
// is an intersection of closed half-planes near the point, and the bend can be cut off.) So the
// ways along free vertices are complete, points of contact and slits of no width included.
#pragma once

#include <optional>
#include <vector>

#include "layer.hpp"

namespace planner {

// Start, corners, goal: lattice points whose coordinates are doubles, joined by free segments.
// Empty: none was found, because a corner that is needed is no double or the work got too much.
std::optional<std::vector<LatticePoint>> find_taut_path(const Layer& layer);

}  // namespace planner
