// The generalized penetration depth PD^g of any two bodies under the displacement metric DISP,
// bracketed by branch and bound over the angle.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "bracket_slices.hpp"
#include "convex_separators.hpp"
#include "pdg/native/pieces/piece_set.hpp"

namespace pdg {

enum class BracketEnd : std::uint8_t {
  kTolerance,  // upper - lower <= rel_tol * upper, under DISP
  kStopped,    // `stop` said so
  kNodes,      // the limit of nodes
  kRounding,   // the range that bounds it is as narrow as roundings allow
};

// lower <= PD^g under DISP <= displaced.displacement, and lower <= PD^g under D_g <=
// distanced.distance, as DISP <= D_g. `lower` is rigorous: true of the exact geometry of the
// doubles given. The poses are free: no interiors of pieces meet, decided exactly for A's vertices
// as placed in doubles; their rounding, 8 u (|a| + |t|), is not in the upper bounds.
struct Bracket {
  double lower = 0.0;
  FreePose displaced;
  FreePose distanced;
  std::uint64_t nodes = 0;   // ranges of angles judged
  std::uint64_t slices = 0;  // Minkowski slices made
  BracketEnd end = BracketEnd::kTolerance;
};

struct BracketLimits {
  double rel_tol = 1e-3;
  std::uint64_t nodes = 0;     // at most so many; 0 still gives a bracket
  std::function<bool()> stop;  // asked between nodes; true ends the search
};

// All bounds are 0 and the poses q0 when the interiors do not meet at q0. The search begins with
// the free poses of drawn_back_upper_bound, with B's separators if they are given.
Bracket bracket_depth(const PieceSet& a, const PieceSet& b, const Pose& q0,
                      const BracketLimits& limits,
                      const std::vector<ConvexSeparator>& separators = {});

}  // namespace pdg
