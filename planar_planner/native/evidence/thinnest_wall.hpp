// Where a proof of absence is nearest to failing: of all ways from start to goal through the
// subdivision, obstacles and all, one whose deepest overlap is least, and where it is deepest.
#pragma once

#include <span>

#include "crossing.hpp"
#include "planar_planner/native/cells/subdivision.hpp"
#include "planar_planner/native/world/scaled_problem.hpp"

namespace planner {

// A crossing from leaf to leaf is as deep as the middle of their common face, if one of them is
// FULL or the face is proven blocked, and counts as free otherwise; goals in FULL leaves do not
// count. The way is one whose deepest crossing is least and whose overlaps, of all such, sum up to
// least; it goes by the middles of faces, theta unwrapped. Then it is sharpened about its deepest,
// which is the wall's thinnest place. Depths are sampled: this is an estimate, no bound. Empty if
// no sample overlaps.
Crossing find_thinnest_wall(const ScaledProblem& problem, const Subdivision& subdivision,
                            std::span<const CellId> start, std::span<const CellId> goal,
                            const DepthAt& depth_at);

}  // namespace planner
