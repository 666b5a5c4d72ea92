// Heuristic constants of this folder, with how each was found. They steer work; whatever their
// values, every answer holds.
#pragma once

#include <cstddef>

namespace planner {

// Where a guess at a goal lies between the nearest point of a part of the region and the part's
// middle, and how much of half an interval of angles it keeps to: on the very edge of neither.
// Chosen, not tuned; any value in (0, 1) will do.
inline constexpr double kInwards = 0.125;

// The guesses that are handed out at once. Chosen, not tuned.
inline constexpr std::size_t kMostGuesses = 8;

// Edges of a polygon under one box. Chosen, not tuned.
inline constexpr std::size_t kEdgesPerRun = 16;

// The origin of the robot's frame is moved to a grid: of those whose differences with the vertices
// are exact the finest, from 52 bits below the largest coordinate, coarser by steps, and at most
// this many bits finer than the body's extent. Chosen, not tuned: an origin that is off by an
// eighth of the body costs no more than an eighth in reach.
inline constexpr int kDoubleBits = 52;
inline constexpr int kOriginGridStep = 6;
inline constexpr int kOriginGridBits = 3;

}  // namespace planner
