// Goal regions: which cells may meet them, and the guesses at goals in them.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <utility>

#include "planar_planner/native/configurations/goal_region.hpp"
#include "planar_planner/native/configurations/quarter_turn.hpp"
#include "planar_planner/native/configurations/scaled_configuration.hpp"

namespace {

using planner::CellBox;
using planner::Configuration;
using planner::GoalRegion;
using planner::GoalSet;
using planner::Vec2;

constexpr double kTurn = 2.0 * std::numbers::pi;

planner::ScaledProblem room() {
  planner::Problem scene;
  scene.robot.append({{{{-0.1, -0.1}, {0.1, -0.1}, {0.1, 0.1}, {-0.1, 0.1}}}});
  scene.box = planner::Rectangle{{100.0, -20.0}, {110.0, -10.0}};
  return planner::make_scaled_problem(std::move(scene));
}

// An L about (105, -15), wound either way.
GoalSet corner(const double size, const bool reversed) {
  pdg::Ring ring;
  for (const Vec2 p : {Vec2{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}})
    ring.push_back(Vec2{104.0, -16.0} + size * p);
  if (reversed) std::reverse(ring.begin(), ring.end());
  GoalSet set;
  set.polygons.append({{ring}});
  return set;
}

CellBox random_box(std::mt19937& random, const int most) {
  CellBox box;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    box.level[axis] = static_cast<std::uint8_t>(random() % static_cast<unsigned>(most));
    if (axis == planner::kTheta && box.level[axis] < 2) box.level[axis] = 2;
    const std::uint64_t cells = std::uint64_t{1} << box.level[axis];
    box.low[axis] = (random() % cells) * box.size(axis);
  }
  return box;
}

// A configuration of the box, by parts of its extents; theta in [0, 2 pi].
Configuration part_of(const planner::ScaledProblem& problem, const CellBox& box, const double x,
                      const double y, const double theta) {
  const auto along = [&](const planner::Axis axis, const double part) {
    return std::ldexp(
        static_cast<double>(box.low[axis]) + part * static_cast<double>(box.size(axis)), -60);
  };
  const planner::Domain& d = problem.domain;
  const Vec2 p = planner::to_user(problem, {d.low.x + d.size.x * along(planner::kX, x),
                                            d.low.y + d.size.y * along(planner::kY, y)});
  return {p.x, p.y, kTurn * along(planner::kTheta, theta)};
}

TEST(GoalRegion, CellsThatHoldAGoalAreNotTakenForOthers) {
  const planner::ScaledProblem problem = room();
  const planner::CellSpace space{problem.domain, true, 0.0};
  std::mt19937 random(11);
  std::uniform_real_distribution<double> part(0.0, 1.0);
  int held = 0;
  int empty = 0;
  for (int k = 0; k < 4000; ++k) {
    GoalSet set = corner(std::pow(2.0, -4.0 * part(random)), k % 2 == 0);
    if (k % 3 != 0) {
      const double low = 40.0 * (part(random) - 0.5);
      set.angles = GoalSet::Angles{low, low + 6.0 * part(random)};
    }
    const GoalRegion region(problem, set);
    const CellBox box = random_box(random, 7);
    const bool may = region.may_meet(space, box);
    empty += !may;
    for (int i = 0; i < 20; ++i) {
      Configuration q = part_of(problem, box, part(random), part(random), part(random));
      if (set.angles) q.theta = planner::nearest_turn(q.theta, set.angles->low + 3.0);
      if (!region.contains(q)) continue;
      ++held;
      ASSERT_TRUE(may);
    }
  }
  EXPECT_GT(held, 200);
  EXPECT_GT(empty, 1000);
}

TEST(GoalRegion, GuessesAreInTheRegion) {
  const planner::ScaledProblem problem = room();
  const planner::CellSpace space{problem.domain, true, 0.0};
  std::mt19937 random(12);
  std::uniform_real_distribution<double> part(0.0, 1.0);
  int found = 0;
  for (int k = 0; k < 2000; ++k) {
    GoalSet set = corner(1.0, k % 2 == 0);
    const double low = 40.0 * (part(random) - 0.5);
    set.angles = GoalSet::Angles{low, low + (k % 5 == 0 ? 0.0 : 6.0 * part(random))};
    const GoalRegion region(problem, set);
    const CellBox box = random_box(random, 6);
    for (const Configuration& q : region.inside(space, box)) {
      ++found;
      ASSERT_TRUE(region.contains(q));
      ASSERT_TRUE(region.may_meet(space, box));
    }
    const Configuration from{102.0, -11.0, 30.0 * (part(random) - 0.5)};
    for (const Configuration& q : region.near(from)) ASSERT_TRUE(region.contains(q));
    const auto sampled = region.sample(part(random), part(random), part(random));
    if (sampled) {
      ASSERT_TRUE(region.contains(*sampled));
    }
  }
  EXPECT_GT(found, 100);
}

TEST(GoalRegion, ACellThatTouchesMayMeetAndOneApartDoesNot) {
  const planner::ScaledProblem problem = room();
  const planner::CellSpace space{problem.domain, true, 0.0};
  CellBox box;
  box.level = {1, 1, 2};  // the lower left quarter: its corner is the middle of the domain
  GoalSet set;
  set.polygons.append({{{{105.0, -15.0}, {107.0, -15.0}, {107.0, -13.0}}}});
  EXPECT_TRUE(GoalRegion(problem, set).may_meet(space, box));
  set = {};
  set.polygons.append({{{{105.000001, -15.0}, {107.0, -15.0}, {107.0, -13.0}}}});
  EXPECT_FALSE(GoalRegion(problem, set).may_meet(space, box));
  set = {};
  set.polygons.append({{{{101.0, -19.0}, {109.0, -19.0}, {109.0, -11.0}}}});
  set.angles = GoalSet::Angles{-1.0, 0.0};  // the seam: turn 0 is turn 1
  EXPECT_TRUE(GoalRegion(problem, set).may_meet(space, box));
  set.angles = GoalSet::Angles{-1.0, -0.000001};
  EXPECT_FALSE(GoalRegion(problem, set).may_meet(space, box));
  set.angles = GoalSet::Angles{0.25 * kTurn, 2.0};
  EXPECT_TRUE(GoalRegion(problem, set).may_meet(space, box));
  set.angles = GoalSet::Angles{1.571, 6.0};
  EXPECT_FALSE(GoalRegion(problem, set).may_meet(space, box));
}

}  // namespace
