// Heuristic constants of this folder, with how each was found. They steer work; whatever their
// values, bounds hold.
#pragma once

namespace pdg {

// --- The bracket of PD^g ---
// The turns in question are first cut into so many ranges. Chosen, not tuned.
inline constexpr int kFirstRanges = 8;
// The descent ends at steps that move A by this part of what the tolerance allows. Chosen, not
// tuned.
inline constexpr double kDescentEnd = 0.05;

// --- Upper bounds ---
// Doublings of the way beyond touching before a placement is given up. Chosen, not tuned.
inline constexpr int kMostDoublings = 4;
// Drawing back: even samples of the way, and halvings of the step before the first free one.
// Chosen, not tuned: 24 halvings leave 2^-28 of the way.
inline constexpr int kSamplesBack = 16;
inline constexpr int kHalvingsBack = 24;

// --- Containment ---
// Intervals of angles to begin with. Two or more keep half-widths within a quarter turn, which
// lowest_support needs. Chosen, not tuned.
inline constexpr int kFirstIntervals = 4;

}  // namespace pdg
