// Walks over cells: level by level as published, or the cells that our own search meets.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "queries.hpp"
#include "read_scene.hpp"
#include "truth.hpp"

namespace bench {

// A cell with everything that the statistics ask of it.
struct Seen {
  Visit visit;
  int level = 0;
  bool inherited = false;  // inside a cell that was known to lie in C-obstacle
  Truth truth = Truth::kNotAll;
  std::array<bool, kQueries> culled{};
};

struct WalkLimits {
  std::size_t cells = 20000;  // no level is begun that may exceed it
  std::size_t budget = 4000;  // labels of one cell's refinement
  bool truth = true;          // without: cells are taken only to be timed
};

// Cells of equal level are split into eight, level by level, unless FREE, star-shaped or identified
// by `driver`: cells that it misses stay in the walk with their children.
std::vector<Seen> walk_levels(World& world, Query driver, const WalkLimits& limits);

// All cells, inner ones included, of the planner's subdivision after the query is answered.
std::vector<Seen> walk_search(World& world, const Task& task, const WalkLimits& limits);

}  // namespace bench
