// The leaves that may hold a goal: all of them for proofs, those worth a look for the search.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "distance_tree.hpp"
#include "planar_planner/native/cells/subdivision.hpp"
#include "planar_planner/native/configurations/goal_region.hpp"

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
  // A wanted leaf held no free goal. Where only contact leads to a region, smaller and smaller
  // leaves seem to hold one: after some in vain those much smaller than the largest are put aside,
  // so that others have their turn. True if the wanted ones are fewer now.
  bool note_vain_goal();
  // They are wanted again: once there are twice as many leaves, or nothing else is left.
  [[nodiscard]] bool due() const { return least_ > 0.0F && subdivision_.size() >= due_; }
  // True if the wanted ones are more now.
  bool take_back();

  [[nodiscard]] const GoalRegion& region() const { return region_; }
  // Those neither given up nor put aside.
  [[nodiscard]] const Roots& wanted() const { return wanted_; }
  [[nodiscard]] std::vector<CellId> all() const;
  // Is any goal cell that was given up reached from this leaf, and none that is wanted?
  [[nodiscard]] bool only_given_up(CellId from) const;

 private:
  [[nodiscard]] bool may_hold(CellId cell) const;
  void put_aside_if_small(CellId cell);

  const GoalRegion& region_;
  const Subdivision& subdivision_;
  Roots wanted_, aside_;
  std::vector<CellId> given_up_;
  float least_ = 0.0F;  // smaller leaves are put aside; 0: none are
  std::size_t due_ = 0;
  std::uint64_t in_vain_ = 0;  // since leaves were last put aside
  std::uint64_t most_in_vain_;
};

}  // namespace planner
