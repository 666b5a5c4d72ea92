// Counts of the leaves, for answers and for who watches a search.
#pragma once

#include "planar_planner/native/statistics.hpp"
#include "subdivision.hpp"

namespace planner {

struct CellCounts {
  LabelCounts by_label;
  LevelCounts by_level;
};

CellCounts take_census(const Subdivision& subdivision);

}  // namespace planner
