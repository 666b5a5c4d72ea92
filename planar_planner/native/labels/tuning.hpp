// Heuristic constants of this folder, with how each was found. They steer work; whatever their
// values, labels and proofs hold.
#pragma once

#include <cstddef>

namespace planner {

// Joint obstruction: choices are tried for at most so many pairs, and at most so many in all. More
// prove hardly more cells (docs/method.md, "Joint obstruction") and cost time on those that they do
// not prove.
inline constexpr std::size_t kBranchingPairs = 2;
inline constexpr std::size_t kMostCases = 9;

// Pivots of the programme for their weights, after which it gives up. Chosen, not tuned.
inline constexpr int kPivots = 24;

// A pair stays closed while the motion radius exceeds a part of its circles' radii: such a cell is
// hardly ever FULL and not worth the pair's functions yet. Smaller opens later: less work a cell,
// weaker labels, more cells. A robot of many pieces is hardly ever stopped by a single one, so
// pairs of its pieces open later, except those whose circles meet at every corner of the
// translations, without which a pair cannot cover the cell. Measured on mazes, fields and chains of
// baffles (two pieces), combs and gears (eleven and more); any positive values are sound.
inline constexpr std::size_t kManyPieces = 8;
inline constexpr double kOpeningOfFew = 0.5;
inline constexpr double kOpeningOfMany = 0.34;
inline constexpr double kCoveringOfMany = 0.7;

}  // namespace planner
