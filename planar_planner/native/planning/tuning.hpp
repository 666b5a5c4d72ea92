// Heuristic constants of this folder, with how each was found. They steer work; whatever their
// values, answers hold.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace planner {

// A try with a disc instead of the robot may cost no more cells than this. Chosen; no
// measurement is on record.
inline constexpr std::uint64_t kDiscCells = 4000;

// Work of the first try before there is a cell, and as much more for every vertex of an obstacle,
// as the cells that it may spare cost more then too: the least that cells cost on 61 open scenes
// and maps was half a microsecond a vertex. Trees that are shut in get the least. In nanoseconds on
// one machine (guesses/tuning.hpp, kCheckWork).
inline constexpr std::uint64_t kLeastTryWork = 280'000;
inline constexpr std::uint64_t kTryWork = 500'000;
inline constexpr std::uint64_t kTryWorkPerVertex = 400;

// Configurations of each leg that are looked at, the middle first, before a certificate of it is
// begun: one that must fail costs more than these looks. Chosen: the eighths.
inline constexpr std::array<double, 7> kGlances = {0.5, 0.25, 0.75, 0.125, 0.375, 0.625, 0.875};

// Cells before a layer is decided exactly: some milliseconds. Chosen: the shipped scenes of robots
// that may not turn take fewer.
inline constexpr std::uint64_t kCellsBeforeLayer = 2000;

// How long the last leg of a way out of contact may be: the robot's reach, rounded down to a power
// of two, times 2^-k. Chosen.
inline constexpr std::array<int, 4> kWayOutLevels = {1, 4, 7, 10};

// Evidence may come so near to touching, as a part of the bound of rounding, if it is then checked
// exactly. The rounding itself is far less than its bound. Chosen.
inline constexpr double kClosestShare = 0.25;

// The size of a layer that is decided exactly, in convex sums and in their vertices. Chosen: about
// a tenth of a second.
inline constexpr std::size_t kMostLayerSums = 100'000;
inline constexpr std::size_t kMostLayerVertices = 1'000'000;

// Open places at one quarter turn that are looked at, the largest, and questions whether two of
// them are joined there, times the layer's sums. Chosen: about a tenth of a second.
inline constexpr std::size_t kMostGates = 48;
inline constexpr std::size_t kGateWork = 300'000;
// Leaves of a subdivision whose regions are looked for: their faces are tested. Chosen: some tenths
// of a second.
inline constexpr std::size_t kMostJoinedLeaves = 100'000;

// The way of a far reference point: the part of the body's room along a segment that the arc's
// deviation may take up before the segment is halved instead, how often one is halved, and how many
// waypoints there may be. Chosen, not tuned: half the room makes fewer waypoints, but evidence that
// has to halve them again, and a smaller bound of the clearance.
inline constexpr double kReferenceRoom = 0.25;
inline constexpr int kDeepestReferencePart = 40;
inline constexpr std::size_t kMostReferenceWaypoints = std::size_t{1} << 16U;

}  // namespace planner
