// Heuristic constants of this folder, with how each was found. They steer work; whatever their
// values, ranges and depths are bounds.
#pragma once

namespace pdg {

// Below this many candidate vertices the full range of a separating-axis function costs no more
// than its quick bound. Chosen by counting operations, not tuned.
inline constexpr int kQuickVertices = 3;

// Largest half-angle (radians; the ranges' limit is pi / 2) of a stretch of orientations; wider
// cells are covered by several. Chosen, not tuned: near the limit, with room for the widening
// below.
inline constexpr double kWidestTurn = 1.5;
// A stretch may be widened by so much (radians) for the rounding of its centre; with this it stays
// below pi / 2.
inline constexpr double kLargestWidening = 0.05;

}  // namespace pdg
