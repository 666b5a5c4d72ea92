// Heuristic constants of the labels, with how each was found. They steer work: whatever their
// values, labels and proofs hold.
#pragma once

#include <cstddef>

namespace planner {

// Joint obstruction: choices are tried for at most so many pairs, and at most so many in all. More
// prove hardly more cells (docs/method.md, "Joint obstruction") and cost time on those that they do
// not prove.
inline constexpr std::size_t kBranchingPairs = 2;
inline constexpr std::size_t kMostCases = 9;

}  // namespace planner
