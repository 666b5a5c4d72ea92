// Proof that two free points of a layer are not joined: a closed chain of open convex sets, each of
// which overlaps the next, that winds round exactly one of the two points (or an odd number of
// times more round one than round the other).
//
// Two points of a compact planar set lie in different components iff a closed curve in its
// complement separates them. Here the complement is a union of open convex sets; pairs of them that
// overlap have a connected union, so that such a curve exists iff the graph of overlapping sets has
// a cycle of odd parity. The parity of a link tells whether the way through it crosses the upward
// ray from the start, added modulo 2 to the same for the goal.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "layer.hpp"

namespace planner {

// What lies outside the domain on one side: an open half-plane.
enum class Side : std::uint8_t { kLeft, kRight, kBelow, kAbove };

// Sums are numbered from 0; -1 - side is a side of the domain.
using ChainLink = std::int32_t;
constexpr ChainLink link_of(const Side side) {
  return -1 - static_cast<ChainLink>(side);
}

// The links of a shortest chain through one of them, in order; the last overlaps the first. Empty:
// start and goal, both free, are joined by a way in the closed free set.
std::optional<std::vector<ChainLink>> find_odd_chain(const Layer& layer);

}  // namespace planner
