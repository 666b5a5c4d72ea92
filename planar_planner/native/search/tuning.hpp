// Heuristic constants of this folder, with how each was found. They steer the search; whatever
// their values, answers hold.
#pragma once

#include <cstdint>

namespace planner {

// Crossing costs, by size = motion radius / robot reach (channel.cpp).
// The values were found by random search over mazes, fields, gears, gates and smaller scenes,
// scored by labelled cells and expansions; two of them also decide whether a search ends:
// - A strip of n = L / size MIXED cells along a contact costs L size^(p - 1). With p < 1 for small
//   cells that grows while the strip is refined, so that it cannot outbid every other channel for
//   ever.
// - A cell that has been halved along one axis again and again without being decided will take more
//   halving yet: its cost grows with its thinness.
inline constexpr double kLargeExponent = 1.25;  // of sizes above 1: prefers what is resolved
inline constexpr double kSmallExponent = 0.5;   // of sizes below 1
inline constexpr double kThinnessCost = 0.25;   // more for every halving of one axis beyond others
inline constexpr double kSolidCost = 0.005;     // FREE or STAR
inline constexpr double kFreeCentreCost = 0.5;  // MIXED, free at the centre by the labels' hint
inline constexpr double kMixedCost = 1.0;       // MIXED, in contact at the centre ...
inline constexpr double kDepthCost = 3.0;       // ... and more for every motion radius of depth

// An orphan keeps its distance if that undercuts its new way by at most this part of its own cost,
// and a reached leaf takes a shorter way if that saves more than this part of its own cost. Larger:
// less mending, worse channels; what is reachable is exact with any. Both were measured twice, on
// the search as it was then; the figures were not kept.
inline constexpr float kSlackDown = 0.9F;
inline constexpr float kSlackUp = 0.6F;

// A round splits the channel's MIXED cells down to this fraction of the largest one's size.
// Smaller: more cells in dead ends; larger: more rounds. Measured over the shipped families; any
// value in (0, 1] is sound.
inline constexpr float kBatch = 0.7F;

// Cells that have been labelled before channels are surveyed for what they are stuck at: below it
// the cells themselves are about as cheap. 4,096 solves a few slanted families with fewer cells and
// makes gear-jammed a third slower for nothing. Surveys may cost so many times what all the rest
// has cost, in evaluations of separating-axis functions; a round that may not ask splits the
// largest cells of the channel. 1 and 4 decide the same families.
inline constexpr std::uint64_t kSurveyFrom = 8192;
inline constexpr std::uint64_t kSurveyShare = 1;
// Work of labelling a cell, of one separating-axis function for it and of one step of the search,
// in nanoseconds on one machine: by least squares over 61 open scenes and maps, each within a third
// of its time. guesses/tuning.hpp counts the first try's work in the same unit.
inline constexpr std::uint64_t kLabelWork = 1300;
inline constexpr std::uint64_t kSeparationWork = 70;
inline constexpr std::uint64_t kStepWork = 160;
// The parts of the cells' work that the first try may do while its trees grow, and after that; and
// the least work of one turn, since each turn costs a little. Chosen.
inline constexpr std::uint64_t kGrowingTreesShare = 16;
inline constexpr std::uint64_t kStuckTreesShare = 64;
inline constexpr std::uint64_t kLeastTurn = 20'000;

// Goal cells that turn out to hold no free goal before small leaves are put aside for the first
// time; each time so many times as many. Fewer: goals that are nearly found wait for others.
// Chosen; no measurement is on record. Any values are sound.
inline constexpr std::uint64_t kVainGoals = 256;
inline constexpr std::uint64_t kVainGoalsGrowth = 2;
// A leaf is small if it is so much smaller than the largest one that is wanted. Chosen, too.
inline constexpr float kSmallGoal = 0.125F;

}  // namespace planner
