// Heuristic constants of this folder, with how each was found. They steer work; whatever their
// values, every answer holds.
#pragma once

#include <cstddef>

namespace planner {

// Sides of the regular polygons that stand for a disc. Chosen, not tuned: they cost a factor of
// cos(pi / 16)^-2 = 1.04 in radius.
inline constexpr int kDiscSides = 16;

// Robots with a larger ratio of their outer to their inner radius are not tried as discs: the two
// scenes would mostly be undecided. Chosen, not tuned.
inline constexpr double kDiscRatio = 1.25;

// Polygons of fewer vertices are decomposed in about the time in which their hull is made and
// asked. From a comparison of the two; its figures were not kept.
inline constexpr std::size_t kHullVertices = 10;

}  // namespace planner
