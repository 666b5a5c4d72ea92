#include "goal_cells.hpp"

namespace planner {

std::vector<CellId> leaves_that_may_meet(const GoalRegion& region, const Subdivision& subdivision) {
  std::vector<CellId> out;
  for (CellId id = 0; id < subdivision.size(); ++id)
    if (region.may_meet(subdivision.space(), subdivision.cell(id).box)) out.push_back(id);
  return out;
}

GoalCells::GoalCells(const GoalRegion& region, const Subdivision& subdivision)
    : region_(region), subdivision_(subdivision), wanted_(subdivision.size()) {
  for (const CellId id : leaves_that_may_meet(region, subdivision)) wanted_[id] = true;
}

bool GoalCells::may_hold(const CellId cell) const {
  return region_.may_meet(subdivision_.space(), subdivision_.cell(cell).box);
}

// Only a leaf that may hold a goal has halves that may.
void GoalCells::after_split(const CellId lower, const CellId upper) {
  const bool whole = wanted_[lower];
  wanted_.resize(subdivision_.size());
  wanted_[lower] = whole && may_hold(lower);
  wanted_[upper] = whole && may_hold(upper);
}

void GoalCells::give_up(const CellId cell) {
  wanted_[cell] = false;
  given_up_.push_back(cell);
}

std::vector<CellId> GoalCells::all() const {
  std::vector<CellId> out = given_up_;
  for (CellId id = 0; id < wanted_.size(); ++id)
    if (wanted_[id]) out.push_back(id);
  return out;
}

bool GoalCells::only_given_up(const CellId from) const {
  if (given_up_.empty()) return false;
  std::vector<CellId> wanted;
  for (CellId id = 0; id < wanted_.size(); ++id)
    if (wanted_[id]) wanted.push_back(id);
  return !subdivision_.connected({&from, 1}, wanted);
}

}  // namespace planner
