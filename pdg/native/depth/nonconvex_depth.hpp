// Translational penetration depth PD^t of any two bodies ([PDG] Eq. 1), and their distance.
#pragma once

#include "pdg/native/pieces/piece_set.hpp"
#include "translational_depth.hpp"

namespace pdg {

// A at the pose, its vertices as placed in doubles. `state` is decided exactly for those. The other
// fields are plain doubles: overlap: the least translation that leaves the interiors disjoint, over
// the whole plane of translations, so that A may end in a hole or a notch of B; apart: minus the
// distance of the bodies. Gaps narrower than half the slice's error bound, 16 u (A + B + T), may be
// taken for free or not (minkowski_slice.hpp; kSliceErrorUnits). Throws std::invalid_argument for
// coordinates outside the range of predicates.hpp.
TranslationalDepth translational_depth(const PieceSet& a, const PieceSet& b, const Pose& pose);

}  // namespace pdg
