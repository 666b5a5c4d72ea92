// Heuristic constants of this folder, with how each was found. They steer work; whatever their
// values, triangulations are right.
#pragma once

#include <cstddef>
#include <cstdint>

namespace pdg {

// Larger polygons have their edges put in: a sweep may leave slivers that take a number of flips
// that is quadratic. Chosen, not tuned.
inline constexpr std::size_t kMostSweptVertices = 2048;

// Where putting edges in takes longer, about a second, such a polygon is swept after all, if it can
// be. Then slivers may stay: any triangulation is right, good angles only make fewer pieces. The
// flips allowed are more than a smaller polygon's square, or a mesh of points with edges, takes.
inline constexpr std::uint64_t kStepsBeforeSweep = 20'000'000;
inline constexpr std::uint64_t kMostFlips = 5'000'000;
inline constexpr std::uint64_t kMostFlipsPerTriangle = 100;

// The largest number of edges that are looked at while the constraints of one polygon make room for
// themselves: some ten seconds. It grows with the square of how many edges a constraint crosses,
// which is few but for thousands of vertices that crowd along lines across it.
inline constexpr std::uint64_t kMostConstraintSteps = 200'000'000;

// Up to so many points are added from left to right, which is quickest but may take a number of
// flips that is quadratic (teeth between two columns); that many take some hundredths of a second.
inline constexpr std::int32_t kSweptPoints = 2048;

// Sets of points of this size are inserted in the order in which they come. Chosen, not tuned.
inline constexpr std::int32_t kSmallRound = 64;

}  // namespace pdg
