// The evidence that no path exists: few FULL cells and faces that separate start from goal, and the
// closed set of cells on the start's side (docs/certificate.md, "separation").
#pragma once

#include <span>
#include <vector>

#include "planar_planner/native/cells/face.hpp"
#include "planar_planner/native/cells/subdivision.hpp"
#include "planar_planner/native/labels/full_claim.hpp"

namespace planner {

struct Barrier {
  std::vector<CellBox> start_side;  // as few boxes as the kd-tree allows
  std::vector<FullClaim> cells;
  std::vector<FullClaim> faces;
};

// A least cut: no other choice among the subdivision's FULL cells and blocked faces that separates
// the two sets of leaves has fewer of them. Empty if none does. FULL leaves among them: those of
// the start are not looked at; those of the goal do not come to the start's side. `blocked` are the
// claims of FaceTest.
Barrier find_barrier(const Subdivision& subdivision, const std::vector<FullClaim>& blocked,
                     std::span<const CellId> start, std::span<const CellId> goal);

}  // namespace planner
