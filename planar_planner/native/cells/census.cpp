#include "census.hpp"

#include <cstddef>

namespace planner {

void take_census(const Subdivision& subdivision, Answer& answer) {
  answer.cells_by_label = {};
  answer.cells_by_level.clear();
  for (CellId id = 0; id < subdivision.size(); ++id) {
    const Cell& cell = subdivision.cell(id);
    ++answer.cells_by_label[static_cast<std::size_t>(cell.label)];
    const std::size_t level =
        std::size_t{cell.box.level[0]} + cell.box.level[1] + cell.box.level[2];
    if (answer.cells_by_level.size() <= level) answer.cells_by_level.resize(level + 1);
    ++answer.cells_by_level[level];
  }
}

}  // namespace planner
