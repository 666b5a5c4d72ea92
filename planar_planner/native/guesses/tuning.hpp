// Heuristic constants of this folder, with how each was found. They steer work; whatever their
// values, every answer holds: guesses prove nothing.
#pragma once

#include <cstddef>
#include <cstdint>

namespace planner {

// --- Trees (rrt_connect) ---
// Longest edge, relative to the diagonal of the domain: of 0.1 to 0.4, what solved most of the
// shipped scenes within a few hundred checks, over 21 seeds.
inline constexpr double kLongestEdge = 0.14;
// The length adapts to the room that there is: shorter by this factor after an edge that was
// blocked, longer after one that passed, but never below this part of the robot's reach. Over 15
// seeds and all scenes with a path that trees find: up to fifty times fewer questions than with one
// length.
inline constexpr double kShorterEdge = 0.8;
inline constexpr double kLongerEdge = 1.15;
inline constexpr double kShortestEdge = 0.6;
// How far a tree grows towards one sample, relative to the robot's reach: a step of the longest
// edge, or shorter ones that make up this way. Between single steps (fence: twice as many
// questions) and growing as far as it goes (open scenes: half as many again), over 100 seeds of
// twelve scenes.
inline constexpr double kLongestGrowth = 2.0;
// Nodes passed over by a search for the nearest that take as long as one question of the hint.
// From a comparison of the two; its figures were not kept.
inline constexpr std::size_t kNodesPerCheck = 64;

// --- Goals of a region (goal_guesses) ---
// Goals that trees grow from at most, and configurations asked about for them: more goals find more
// ways in, but each has to grow its own way out. Chosen, not tuned.
inline constexpr std::size_t kMostGoalTrees = 12;
inline constexpr int kGoalSamples = 60;

// --- One climb (ridge) ---
// Measured over the families of bench/error_time.py; none of them steers more than work.
// Steps of one climb, rejected ones included. On a ridge each squares what is left.
inline constexpr int kClimbSteps = 5;
// A climb ends where the clearance is this part of its radius, or the next step promises less than
// that part of the clearance.
inline constexpr double kRoomy = 0.125;
inline constexpr double kEnough = 0.1;
// Steps after one that gained nothing are so much shorter.
inline constexpr double kShorterStep = 0.25;
// Bounds the length of a gradient: 1 by translation, about 1 by turning where pieces are near.
inline constexpr double kSteepest = 1.5;
// An axis is good if it separates its pair by this part of what the best one does. In a gate the
// edges of both bodies are: all of them together hold the robot aligned, each alone lets it tilt.
inline constexpr double kGood = 0.5;
// Terms that one step may take in or let go (max_min): a hint needs no more. Chosen, not tuned.
inline constexpr int kExchanges = 40;

// --- A path of climbs (ridge_path) ---
// How often a gap may be halved. Two suffice to enter a gate and to leave it; where more are needed
// the channel is still too coarse.
inline constexpr int kGapHalvings = 3;

// --- When it is tried (ridge_attempts) ---
// docs/method.md states them with their effect; how they were found is not on record.
// Channels are too coarse before so many cells have been labelled.
inline constexpr std::uint64_t kFirstAttempt = 128;
// A try is due again when so many times as many cells have been labelled, or when the work since
// the last one is so many times its own. Work is counted in evaluations of separating-axis
// functions.
inline constexpr std::uint64_t kCellGrowth = 2;
inline constexpr std::uint64_t kWorkRatio = 20;
// What a try may cost: so much, and one part in so many of the work before.
inline constexpr std::uint64_t kLeastWork = 1000;
inline constexpr std::uint64_t kWorkShare = 24;

}  // namespace planner
