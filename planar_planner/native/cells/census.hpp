// Counts of the leaves, for answers and for who watches a search.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "subdivision.hpp"

namespace planner {

struct Census {
  std::array<std::uint64_t, 4> by_label{};  // indexed by Label
  std::vector<std::uint64_t> by_level;      // by the sum of the three axes' levels
};

Census take_census(const Subdivision& subdivision);

}  // namespace planner
