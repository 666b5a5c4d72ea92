#include "goal_cells.hpp"

#include <algorithm>

#include "tuning.hpp"

namespace planner {

std::vector<CellId> leaves_that_may_meet(const GoalRegion& region, const Subdivision& subdivision) {
  std::vector<CellId> out;
  for (CellId id = 0; id < subdivision.size(); ++id)
    if (region.may_meet(subdivision.space(), subdivision.cell(id).box)) out.push_back(id);
  return out;
}

GoalCells::GoalCells(const GoalRegion& region, const Subdivision& subdivision)
    : region_(region),
      subdivision_(subdivision),
      wanted_(subdivision.size()),
      aside_(subdivision.size()),
      most_in_vain_(kVainGoals) {
  for (const CellId id : leaves_that_may_meet(region, subdivision)) wanted_[id] = true;
}

bool GoalCells::may_hold(const CellId cell) const {
  return region_.may_meet(subdivision_.space(), subdivision_.cell(cell).box);
}

// Only a leaf that may hold a goal has halves that may.
void GoalCells::after_split(const CellId lower, const CellId upper) {
  const bool wanted = wanted_[lower];
  const bool aside = aside_[lower];
  wanted_.resize(subdivision_.size());
  aside_.resize(subdivision_.size());
  for (const CellId half : {lower, upper}) {
    wanted_[half] = wanted && may_hold(half);
    aside_[half] = aside && may_hold(half);
    put_aside_if_small(half);
  }
}

void GoalCells::put_aside_if_small(const CellId cell) {
  if (!wanted_[cell] || subdivision_.cell(cell).size >= least_) return;
  wanted_[cell] = false;
  aside_[cell] = true;
}

bool GoalCells::note_vain_goal() {
  if (++in_vain_ < most_in_vain_) return false;
  in_vain_ = 0;
  most_in_vain_ *= kVainGoalsGrowth;
  float largest = 0.0F;
  for (CellId id = 0; id < wanted_.size(); ++id)
    if (wanted_[id]) largest = std::max(largest, subdivision_.cell(id).size);
  least_ = std::max(least_, kSmallGoal * largest);
  due_ = 2 * subdivision_.size();
  for (CellId id = 0; id < wanted_.size(); ++id) put_aside_if_small(id);
  return true;
}

bool GoalCells::take_back() {
  least_ = 0.0F;
  bool any = false;
  for (CellId id = 0; id < aside_.size(); ++id) {
    if (!aside_[id]) continue;
    aside_[id] = false;
    wanted_[id] = any = true;
  }
  return any;
}

void GoalCells::give_up(const CellId cell) {
  wanted_[cell] = false;
  given_up_.push_back(cell);
}

std::vector<CellId> GoalCells::all() const {
  std::vector<CellId> out = given_up_;
  for (CellId id = 0; id < wanted_.size(); ++id)
    if (wanted_[id] || aside_[id]) out.push_back(id);
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
