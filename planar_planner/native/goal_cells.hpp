// The leaves that may hold a goal: all of them for proofs, those worth a look for the search.
#pragma once

#include <vector>

#include "distance_tree.hpp"
#include "goal_region.hpp"
#include "subdivision.hpp"

namespace planner {

// Every leaf, FULL ones included, that is not proven to lie outside the region.
std::vector<CellId> leaves_that_may_meet(const GoalRegion& region, const Subdivision& subdivision);

// Kept up to date while leaves are split.
class GoalCells {
 public:
  // Both must outlive it.
  GoalCells(const GoalRegion& region, const Subdivision& subdivision);

  void after_split(CellId lower, CellId upper);
  // No goal can be found in a leaf that cannot be split any further. It may hold one all the same.
  void give_up(CellId cell);

  [[nodiscard]] const GoalRegion& region() const { return region_; }
  // Those not given up.
  [[nodiscard]] const Roots& wanted() const { return wanted_; }
  [[nodiscard]] std::vector<CellId> all() const;
  // Is any goal cell that was given up reached from this leaf, and none that is wanted?
  [[nodiscard]] bool only_given_up(CellId from) const;

 private:
  [[nodiscard]] bool may_hold(CellId cell) const;

  const GoalRegion& region_;
  const Subdivision& subdivision_;
  Roots wanted_;
  std::vector<CellId> given_up_;
};

}  // namespace planner
