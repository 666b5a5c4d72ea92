// An order of inserting points with which triangulating them takes O(n log n) expected time.
#pragma once

#include <vector>

#include "point_mesh.hpp"

namespace pdg {

// All points from `first` on, each once. Fixed: the same points give the same order.
std::vector<Index> insertion_order(const std::vector<Vec2>& sorted_points, Index first);

}  // namespace pdg
