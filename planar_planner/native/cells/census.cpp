#include "census.hpp"

#include <cstddef>

namespace planner {

CellCounts take_census(const Subdivision& subdivision) {
  CellCounts counts;
  for (CellId id = 0; id < subdivision.size(); ++id) {
    const Cell& cell = subdivision.cell(id);
    ++counts.by_label.of[static_cast<std::size_t>(cell.label)];
    const std::size_t level =
        std::size_t{cell.box.level[0]} + cell.box.level[1] + cell.box.level[2];
    if (counts.by_level.size() <= level) counts.by_level.resize(level + 1);
    ++counts.by_level[level];
  }
  return counts;
}

}  // namespace planner
