// Heuristic constants of this folder, with how each was found. They steer work; whatever their
// values, answers hold.
#pragma once

#include <array>
#include <cstdint>

namespace planner {

// A try with a disc instead of the robot may cost no more cells than this. Chosen; no
// measurement is on record.
inline constexpr std::uint64_t kDiscCells = 4000;

// Work of the first try before there is a cell, and as much more for every vertex of an obstacle,
// as the cells that it may spare cost more then too: the least that cells cost on 61 open scenes
// and maps was half a microsecond a vertex. Trees that are shut in get the least. In nanoseconds on
// one machine (guesses/tuning.hpp, kCheckWork).
inline constexpr std::uint64_t kLeastTryWork = 350'000;
inline constexpr std::uint64_t kTryWork = 500'000;
inline constexpr std::uint64_t kTryWorkPerVertex = 400;

// Configurations of each leg that are looked at, the middle first, before a certificate of it is
// begun: one that must fail costs more than these looks. Chosen: the eighths.
inline constexpr std::array<double, 7> kGlances = {0.5, 0.25, 0.75, 0.125, 0.375, 0.625, 0.875};

}  // namespace planner
