// The planner's labels, confirmed or not by the exact side alone.
#pragma once

#include "planar_planner/native/labels/full_claim.hpp"
#include "world.hpp"

namespace rounding {

// Every robot piece is apart from every obstacle piece and inside the walls, all over the box.
bool confirm_free(const World& world, const exact::Box& box);
// The witness pair overlaps all over the box; or the weighted sum of a joint proof is negative, and
// so is every other separating-axis function of its pairs.
bool confirm_full(const World& world, const planner::FullClaim& claim, const exact::Box& box);
bool confirm_pair(const World& world, const planner::Witness& witness, const exact::Box& box);
// The guard is free, and every term that can vanish in the box satisfies the condition under which
// the free part is star-shaped about it (docs/method.md).
bool confirm_star(const World& world, const Vec2 guard, const exact::Box& box);

}  // namespace rounding
