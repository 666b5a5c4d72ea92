#include "census.hpp"

#include <cstddef>

namespace planner {

Census take_census(const Subdivision& subdivision) {
  Census census;
  for (CellId id = 0; id < subdivision.size(); ++id) {
    const Cell& cell = subdivision.cell(id);
    ++census.by_label[static_cast<std::size_t>(cell.label)];
    const std::size_t level =
        std::size_t{cell.box.level[0]} + cell.box.level[1] + cell.box.level[2];
    if (census.by_level.size() <= level) census.by_level.resize(level + 1);
    ++census.by_level[level];
  }
  return census;
}

}  // namespace planner
