// Whether a cell lies in C-obstacle, decided by refining it: slow, bounded, never wrong.
#pragma once

#include <cstddef>
#include <cstdint>

#include "queries.hpp"

namespace bench {

enum class Truth : std::uint8_t {
  kObstacle,   // every configuration is in C-obstacle
  kNotAll,     // a free configuration was found
  kUndecided,  // neither within the budget: contact comes as near as the refinement sees
};

// `list` is what the cell itself leaves undecided (of a MIXED cell). Refines best first by the
// labelling's hint, at most `budget` labels. With `joint` several pairs together count too.
Truth refine(World& world, const planner::Extent& box, const planner::ConstraintList& list,
             std::size_t budget, bool joint);

// Halves of the box along the axis that moves the robot most.
std::array<planner::Extent, 2> halves_of(const World& world, const planner::Extent& box);

}  // namespace bench
