// Heuristic constants of this folder. They steer the work; whatever their values, answers hold.
#pragma once

#include <cstddef>
#include <cstdint>

namespace planner {

// A way is looked for among the nearest corners of each corner first, then among so many times as
// many, until all are tried.
inline constexpr std::size_t kNearestCorners = 16;
inline constexpr std::size_t kNearestGrowth = 4;

// Corners from which a way out of contact is looked for. Chosen.
inline constexpr std::size_t kWayOutCorners = 64;

// Tests of segments after which the way is given up and the cells are asked.
inline constexpr std::uint64_t kMostSegmentTests = 2'000'000;

}  // namespace planner
