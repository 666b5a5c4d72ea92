// The boxes and faces that separate start from goal as plain columns in the user's units, for
// whoever draws them. They are rounded: no proof rests on them.
#pragma once

#include "evidence.hpp"
#include "planar_planner/native/cells/cell_table.hpp"

namespace planner {

// The claims of a barrier, cells first; a face has no extent along its normal. `problem` is the one
// whose cells they are: for ClaimKind::kDisc the disc's. Theta runs from 0 to a turn; without
// rotation every claim holds for all of it, which is right for a disc only.
CellTable tabulate(const ScaledProblem& problem, const Barrier& barrier);

}  // namespace planner
