// The check of single configurations against placement, which labels, and against separating axes
// in long double.
#include <gtest/gtest.h>

#include "planar_planner/native/configurations/scaled_configuration.hpp"
#include "planar_planner/native/paths/placement.hpp"
#include "planar_planner/native/paths/state_check.hpp"
#include "planner_worlds.hpp"

namespace {

using planner::Configuration;
using planner::PlacementState;
using planner::StateCheck;
using worlds::Random;
using worlds::Real;
using worlds::World;

// Beyond this separation (planner units, the scene's extent is 1 to 2) rounding is no excuse: the
// far recipe's coordinates are 1e7 times larger than its scene, but the frame is moved to it.
constexpr Real kBeyondRounding = 1e-12L;

Configuration random_configuration(Random& random, const planner::Rectangle& bounds) {
  const auto along = [&](const double low, const double high) {
    const double overshoot = 0.05 * (high - low);  // some are out of bounds
    return worlds::uniform(random, low - overshoot, high + overshoot);
  };
  return {along(bounds.low.x, bounds.high.x), along(bounds.low.y, bounds.high.y),
          worlds::uniform(random, -10.0, 10.0)};
}

// `q` moved along x to where the oracle's separation changes sign, to within an ulp or so.
Configuration towards_contact(const World& world, Configuration q, Configuration other) {
  const auto separation = [&](const double x) {
    const planner::ScaledConfiguration pose = planner::scaled(world.problem, {x, q.y, q.theta});
    return world.oracle.separation({pose.t.x, pose.t.y, pose.theta});
  };
  const bool side = separation(q.x) > 0;
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (q.x + other.x);
    ((separation(middle) > 0) == side ? q.x : other.x) = middle;
  }
  return q;
}

struct Tally {
  int free = 0;
  int colliding = 0;
  int near = 0;
};

void compare(World& world, StateCheck& check, const Configuration& q, Tally& tally) {
  const bool free = check.is_free(q);
  const planner::ScaledConfiguration pose = planner::scaled(world.problem, q);
  const Real separation = world.oracle.separation({pose.t.x, pose.t.y, pose.theta});
  const planner::Placement placement = planner::place(world.problem, world.tree, world.labeller, q);
  if (free) {
    ++tally.free;
    ASSERT_GT(separation, 0.0L) << "FALSE CLAIM";
    ASSERT_EQ(placement.state, PlacementState::kFree);
  } else {
    ++tally.colliding;
    ASSERT_LT(separation, kBeyondRounding);
    if (placement.state == PlacementState::kFree) {
      ASSERT_LT(placement.clearance, planner::length_to_user(world.problem, 1e-12));
    }
  }
  if (std::abs(separation) < kBeyondRounding) ++tally.near;
}

TEST(PlannerStateCheck, AgreesWithPlacementAndOracle) {
  Tally tally;
  const std::vector<worlds::Recipe> recipes = worlds::recipes();
  for (std::uint64_t seed = 0; seed < 45; ++seed) {
    SCOPED_TRACE(seed);
    Random random(9100 + seed);
    World world(worlds::random_scene(random, recipes[seed % recipes.size()]));
    StateCheck check(world.problem);
    for (int i = 0; i < 300; ++i) {
      const Configuration q = random_configuration(random, check.bounds());
      compare(world, check, q, tally);
      if (HasFatalFailure()) return;
      if (i % 10 != 0) continue;
      const Configuration other = random_configuration(random, check.bounds());
      compare(world, check, towards_contact(world, q, other), tally);
      if (HasFatalFailure()) return;
    }
    EXPECT_EQ(check.checks(), 330U);
  }
  EXPECT_GT(tally.free, 2000);
  EXPECT_GT(tally.colliding, 2000);
  EXPECT_GT(tally.near, 200);
}

planner::Problem square_in_room() {
  planner::Problem scene;
  scene.robot.append({{{{-0.5, -0.5}, {0.5, -0.5}, {0.5, 0.5}, {-0.5, 0.5}}}});
  scene.obstacles.append({{{{2, 0}, {3, 0}, {3, 1}, {2, 1}}}});
  scene.box = planner::Rectangle{{-4, -4}, {4, 4}};
  return scene;
}

TEST(PlannerStateCheck, TouchingCountsAsNotFree) {
  StateCheck check(planner::make_scaled_problem(square_in_room()));
  EXPECT_FALSE(check.is_free({1.5, 0.5, 0.0}));  // the obstacle
  EXPECT_TRUE(check.is_free({1.5 - 0x1p-40, 0.5, 0.0}));
  EXPECT_FALSE(check.is_free({1.5, 1.5, 0.0}));   // its corner
  EXPECT_FALSE(check.is_free({-3.5, 0.0, 0.0}));  // a wall
  EXPECT_TRUE(check.is_free({-3.5 + 0x1p-40, 0.0, 0.0}));
}

TEST(PlannerStateCheck, RefusesWhatIsOutOfBoundsOrNoNumber) {
  planner::Problem scene = square_in_room();
  scene.reference_bounds = planner::Rectangle{{-1, -1}, {1, 1}};
  StateCheck check(planner::make_scaled_problem(scene));
  EXPECT_TRUE(check.is_free({1.0, -1.0, 0.3}));
  EXPECT_FALSE(check.is_free({std::nextafter(1.0, 2.0), 0.0, 0.0}));
  for (const double bad : {double{NAN}, double{INFINITY}, 1e308}) {
    EXPECT_FALSE(check.is_free({bad, 0.0, 0.0}));
    EXPECT_FALSE(check.is_free({0.0, -bad, 0.0}));
  }
  EXPECT_FALSE(check.is_free({0.0, 0.0, NAN}));
  EXPECT_FALSE(check.is_free({0.0, 0.0, -INFINITY}));
}

// The bounds hold every free configuration; only obstacles within reach of them are kept.
TEST(PlannerStateCheck, BoundsAndFarObstacles) {
  planner::Problem scene = square_in_room();
  scene.obstacles.append({{{{1e9, 0}, {1e9 + 1, 0}, {1e9, 1}}}});
  StateCheck check(planner::make_scaled_problem(scene));
  EXPECT_TRUE(check.is_free({1.5 - 0x1p-40, 0.5, 0.0}));
  EXPECT_NEAR(check.bounds().low.x, -3.5, 1e-9);
  EXPECT_NEAR(check.bounds().high.y, 3.5, 1e-9);
  EXPECT_NEAR(check.robot_radius(), std::sqrt(0.5), 1e-12);
}

}  // namespace
