// Heuristic constants of this folder, with how each was found. They steer work; whatever their
// values, every certificate holds.
#pragma once

#include <array>
#include <cstddef>

namespace planner {

// A segment that needs more labelled intervals, or deeper bisection, counts as not certified.
// Chosen with the first search, not tuned since: a path whose segments do not get by with it is
// refined.
inline constexpr int kMostIntervals = 2000;
inline constexpr std::size_t kDeepestInterval = 44;

// The parts that evidence cuts a segment into are halved at most so often, and there are at most so
// many. Chosen, not tuned: far more than a certified segment takes.
inline constexpr int kDeepestPart = 50;
inline constexpr std::size_t kMostParts = 1U << 20U;

// A part is short, and polygons near it are decomposed, if it moves the robot by at most this part
// of its reach either way from the middle. Chosen.
inline constexpr double kShortPart = 1.0;

// A path's least clearance is reported to this relative accuracy, unless the number of intervals
// runs out. Chosen, not tuned: what a user reads it for.
inline constexpr double kClearanceTolerance = 0.05;
inline constexpr int kClearanceIntervals = 400;

// The part of the path's clearance that a shortcut has to keep. Chosen, not tuned.
inline constexpr double kKeptClearance = 0.5;

// Where a shortcut is looked at before it is certified: a certificate that must fail costs more
// than one that succeeds. Chosen, not tuned.
inline constexpr std::array<double, 3> kShortcutGlances = {0.5, 0.25, 0.75};

// Directions and lengths in which a way out of a contact is looked for: a full turn in 64 steps,
// from 4^-6 of the tolerance upwards. Chosen, not tuned.
inline constexpr int kDirections = 64;
inline constexpr int kLengths = 7;

// A hull that is this part of the robot's reach away is far enough for an estimate of the
// clearance: the polygon in it is not decomposed for a better one. Chosen, not tuned.
inline constexpr double kFarHull = 0.1;

// Scenes with at most so many obstacle vertices are decomposed in less time than a first try takes.
// From a comparison of the two; its figures were not kept.
inline constexpr std::size_t kSmallScene = 300;

}  // namespace planner
