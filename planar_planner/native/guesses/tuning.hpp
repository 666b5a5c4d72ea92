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
// A tree lags behind if the other one holds more than so many times as many boxes.
inline constexpr std::size_t kLaggingBoxes = 2;
// How far a tree's surroundings reach beyond it, relative to the robot's reach. Chosen.
inline constexpr double kSurroundings = 1.0;
// Work of one question of the hint, of one of its units (CollisionHint::work) and of one node
// passed on the way to the nearest, in nanoseconds on one machine: by least squares over 61 maps,
// each within a factor of two. Search::cells_work counts in the same unit.
inline constexpr std::uint64_t kCheckWork = 60;
inline constexpr std::uint64_t kHintWork = 4;
inline constexpr std::uint64_t kNodeWork = 6;
// Trees are growing if so many samples have led to at least so many boxes that were empty (a reach
// times a reach times an eighth of a turn). Chosen: trees in closed rooms fill those within two
// hundred samples.
inline constexpr std::uint64_t kStockSamples = 128;
inline constexpr std::uint64_t kNewBoxes = 2;

// --- First try (first_try) ---
// How far the trees' configurations are apart at first, relative to the robot's reach; by what
// factor they come nearer after a path that could not be certified, and to what at the nearest.
// Chosen. To look along a path eight times as finely before it is certified costs more than the
// certificates that fail.
inline constexpr double kTrySpacing = 0.25;
inline constexpr double kFinerSpacing = 0.7;
inline constexpr double kFinestSpacing = 0.01;
// Work of one separating-axis function of a certificate, in the unit of kCheckWork.
inline constexpr std::uint64_t kEvaluationWork = 70;

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

// Parabolas in theta on the way to a smooth crest, each so much narrower than the last: what is
// left of the angle is of the third order in the width. Chosen, not tuned.
inline constexpr int kCrestSteps = 3;
inline constexpr double kNarrowerCrest = 0.125;

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
