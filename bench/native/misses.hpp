// Why the queries per normal miss a cell that lies in C-obstacle.
#pragma once

#include <cstddef>

#include "walk.hpp"

namespace bench {

struct Misses {
  std::size_t closed = 0;   // one pair covers the cell, but had not been opened yet
  std::size_t slack = 0;    // one open pair covers it: the ranges are too wide
  std::size_t several = 0;  // no single pair covers it
  std::size_t unclear = 0;  // not decided within the budget
};

// Adds one cell that `Query::kLabel` misses.
void classify(World& world, const Seen& seen, Misses& misses);

}  // namespace bench
