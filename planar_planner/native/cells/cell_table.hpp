// The leaves of a subdivision as plain columns in the user's units, for whoever draws or counts
// them. They are rounded: no proof rests on them.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "planar_planner/native/world/scaled_problem.hpp"
#include "subdivision.hpp"

namespace planner {

struct CellTable {
  std::vector<std::array<double, 3>> lower,
      upper;  // corners: x, y in user's units, theta in radians
  std::vector<std::array<std::uint8_t, 3>> level;  // halvings along x, y and theta
  std::vector<Label> label;
};

// Theta runs from 0 to a turn; without rotation both corners have the fixed angle.
CellTable tabulate(const ScaledProblem& problem, const Subdivision& subdivision);

}  // namespace planner
