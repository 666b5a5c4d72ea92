// Lower bound of the generalized penetration depth PD^g of non-convex bodies.
#pragma once

#include <cstddef>
#include <vector>

#include "pdg/native/pieces/piece_set.hpp"
#include "placed_body.hpp"
#include "translational_depth.hpp"

namespace pdg {

struct DepthLowerBound {
  double depth = 0.0;  // 0 when no pair of pieces overlaps
  int piece_a = -1;    // the deepest pair; -1 when none overlaps
  int piece_b = -1;
  TranslationalDepth pair;  // its PD^t in B's frame; only valid when there is a pair
};

// Storage that a series of queries uses again.
struct DepthScratch {
  struct Candidate {
    double depth = 0.0;  // within the body's `error`
    std::size_t piece_a = 0;
    std::size_t piece_b = 0;
  };
  PlacedBody placed;
  std::vector<Candidate> candidates;
  ConvexPolygon piece;  // of the placed body
};

// max over pairs of PD^t(A_i(q), B_j) ([PDG] section 6.1): PD^g is at least that, under D_g and
// under DISP. Both bodies' hierarchies drop pairs whose boxes overlap by less than the best depth
// so far; the pairs that rounding cannot tell from the deepest are computed as translational_depth
// does, and the first of equally deep ones wins. Plain doubles, for the vertices of A as placed in
// doubles. Throws std::invalid_argument for a deepest pair outside the range of predicates.hpp.
DepthLowerBound generalized_depth_lower_bound(const PieceSet& a, const PieceSet& b,
                                              const Pose& pose, DepthScratch& scratch);
DepthLowerBound generalized_depth_lower_bound(const PieceSet& a, const PieceSet& b,
                                              const Pose& pose);

// Whether no pair of pieces overlaps, so that the bodies' interiors are disjoint: exact, for the
// vertices of A as placed in doubles; by overlap_exactly, with its exception, where rounding leaves
// a pair open.
bool interiors_are_disjoint(const PieceSet& a, const PieceSet& b, const Pose& pose,
                            DepthScratch& scratch);

}  // namespace pdg
