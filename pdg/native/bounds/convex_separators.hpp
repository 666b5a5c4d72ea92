// Convex separators of a fixed body: convex containers that hold nothing of its interior ([PDG]
// sections 6.2.3 and 6.2.4).
#pragma once

#include <vector>

#include "pdg/native/pieces/piece_set.hpp"

namespace pdg {

// {p : normal . p <= offset}, unit normal.
struct HalfPlane {
  Vec2 normal;
  double offset = 0.0;
};

// The container is the intersection of two or more half-planes. Each convex piece of the body lies
// beyond one of them, up to `error` (length), the rounding of a separating-axis function.
struct ConvexSeparator {
  std::vector<HalfPlane> sides;
  double error = 0.0;
};

// Containers round the pieces of a convex cover of the body's complement, holes included: each such
// piece is relaxed to an intersection of half-planes, one for each piece of the body that would
// otherwise meet it; of the lines along edges that do so the one that leaves most room. Containers
// inside others, and those beyond a line from all of the body, which the convex hulls account for,
// are left out. Needs
// body.outline. Where polygons of one body cross, the gaps that several of them enclose are not
// searched. Deterministic.
std::vector<ConvexSeparator> convex_separators(const PieceSet& body);

}  // namespace pdg
