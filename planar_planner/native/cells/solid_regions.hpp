// Groups of solid leaves that hang together by open links: free configurations of a group that
// their leaves' guards see can be reached from each other inside the group.
#pragma once

#include <cstdint>
#include <vector>

#include "face.hpp"
#include "subdivision.hpp"

namespace planner {

inline constexpr std::uint32_t kNoRegion = UINT32_MAX;

// The number of each leaf's group, by id; kNoRegion for a leaf that is not solid.
std::vector<std::uint32_t> solid_regions(const Subdivision& subdivision, FaceTest& faces);

// FREE leaves that hold the angle of so many quarter turns, 0 to 3: of each group that hangs
// together at this angle a largest one. Larger ones first, ties by id.
std::vector<CellId> free_leaves_at(const Subdivision& subdivision, int quarters);

// Solid leaves from one to another, each with an open link to the next, as few as there are; empty
// if they are in different groups.
std::vector<CellId> solid_way(const Subdivision& subdivision, FaceTest& faces, CellId from,
                              CellId to);

}  // namespace planner
