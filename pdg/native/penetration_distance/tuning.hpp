// Heuristic constants of this folder, with how each was found. They steer work; whatever their
// values, bounds hold.
#pragma once

#include <cstddef>

namespace pdg {

// Steps of the GJK start before the hull goes on from what it has: ten times what was ever seen.
inline constexpr std::size_t kMostStartSteps = 1000;

}  // namespace pdg
