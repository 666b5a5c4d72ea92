// Lower bound of the generalized penetration depth PD^g of non-convex bodies.
#pragma once

#include "piece_set.hpp"
#include "translational_depth.hpp"

namespace pdg {

struct DepthLowerBound {
  double depth = 0.0;  // 0 when no pair of pieces overlaps
  int piece_a = -1;    // the deepest pair; -1 when none overlaps
  int piece_b = -1;
  TranslationalDepth pair;  // its PD^t in B's frame; only valid when there is a pair
};

// max over pairs of PD^t(A_i(q), B_j) ([PDG] section 6.1): PD^g is at least that, under D_g and
// under DISP. Pairs whose boxes miss each other are dropped by B's hierarchy. Plain doubles, for
// the vertices of A as placed in doubles.
DepthLowerBound generalized_depth_lower_bound(const PieceSet& a, const PieceSet& b,
                                              const Pose& pose);

}  // namespace pdg
