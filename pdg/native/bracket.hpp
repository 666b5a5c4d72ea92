// The generalized penetration depth PD^g of any two bodies under the displacement metric DISP,
// bracketed by branch and bound over the angle.
#pragma once

#include <cstdint>
#include <functional>

#include "piece_set.hpp"

namespace pdg {

enum class BracketEnd : std::uint8_t {
  kTolerance,  // upper - lower <= rel_tol * upper
  kStopped,    // `stop` said so
  kNodes,      // the limit of nodes
  kRounding,   // no range of angles left that doubles can split
};

// lower <= PD^g <= upper under DISP, for the exact geometry of the doubles given, and DISP(q0,
// pose) <= upper, where `pose` is free: no interiors of pieces meet, decided exactly for the
// vertices as placed in doubles. That `upper` is an upper bound is true of those vertices: their
// rounding, 8 u (|a| + |t|), is not in it.
struct Bracket {
  double lower = 0.0;
  double upper = 0.0;
  Pose pose;
  std::uint64_t nodes = 0;   // ranges of angles judged
  std::uint64_t slices = 0;  // Minkowski slices made
  BracketEnd end = BracketEnd::kTolerance;
};

struct BracketLimits {
  double rel_tol = 1e-3;
  std::uint64_t nodes = 0;     // at most so many
  std::function<bool()> stop;  // asked between nodes; true ends the search
};

// Both bounds are 0 and the pose is q0 when the interiors do not meet at q0.
Bracket bracket_depth(const PieceSet& a, const PieceSet& b, const Pose& q0,
                      const BracketLimits& limits);

}  // namespace pdg
