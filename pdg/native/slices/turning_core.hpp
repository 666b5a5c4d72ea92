// What stays covered while a body turns: a slice that holds for a range of angles.
#pragma once

#include "minkowski_slice.hpp"
#include "slice_pieces.hpp"

namespace pdg {

// A turns by delta, |delta| <= half, about the origin of its pieces' frame.
struct Turn {
  double half = 0.0;  // radians, less than pi / 2
  double cos = 1.0;   // of it
  double sin = 0.0;
};

Turn turn_by(double half);

// Adds a convex polygon inside the intersection, over the turn, of B_j + (-R(delta) A_i); equal to
// it but for terms of second order in the half-angle. A translation at which the interiors of A_i,
// turned by some such delta, and B_j are disjoint is outside it.
//
// An edge of B keeps its normal n: its half-plane's offset is the least over delta,
//   n . b - max over delta of min over a of n . R(delta) a,
// and the lower envelope of sinusoids in the middle has its maxima at the ends, at peaks and where
// an edge of A comes to face n. An edge of A (m, c), M = R(delta) m, turns about a vertex b:
//   M . (b - t) < c for all delta between two angles follows from that at the two, with c cos h in
// place of c > 0, h half their difference (M is the ends' combination with weights of sum
// cos(delta - middle) / cos h). The vertex changes only where an edge of B faces M, so there and at
// the ends of the turn a half-plane each does.
void add_turning_core(const SlicePiece& a, const SlicePiece& b, const Turn& turn,
                      ObstacleSlice& slice);

}  // namespace pdg
