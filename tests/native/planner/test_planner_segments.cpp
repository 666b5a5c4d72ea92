// Certified straight motions against dense samples and a pattern search along them, in long double.
#include <gtest/gtest.h>

#include "planar_planner/native/paths/clearance.hpp"
#include "planar_planner/native/paths/segment.hpp"
#include "planner_worlds.hpp"

namespace {

using planner::ScaledConfiguration;
using worlds::Random;
using worlds::Real;
using worlds::World;

worlds::Point point_at(const ScaledConfiguration& from, const ScaledConfiguration& to,
                       const Real s) {
  return {from.t.x + s * (to.t.x - Real{from.t.x}), from.t.y + s * (to.t.y - Real{from.t.y}),
          from.theta + s * (to.theta - Real{from.theta})};
}

// Least separation along the motion: dense samples, then golden sections about the best of them.
Real least_along(const World& world, const ScaledConfiguration& from, const ScaledConfiguration& to,
                 const int samples, const bool distance = false) {
  const auto value = [&](const Real s) {
    const worlds::Point q = point_at(from, to, s);
    return distance ? world.oracle.distance(q) : world.oracle.separation(q);
  };
  Real best = INFINITY;
  Real at = 0;
  for (int i = 0; i <= samples; ++i) {
    const Real s = static_cast<Real>(i) / samples;
    if (value(s) < best) {
      best = value(s);
      at = s;
    }
  }
  for (Real step = 0.5L / samples; step > 1e-9L; step /= 2)
    for (const Real s : {at - step, at + step}) {
      if (s < 0 || s > 1 || value(s) >= best) continue;
      best = value(s);
      at = s;
    }
  return best;
}

ScaledConfiguration random_pose(Random& random, const World& world, const double turn) {
  const planner::Domain& d = world.problem.domain;
  return {{d.low.x + d.size.x * worlds::uniform(random, 0.0, 1.0),
           d.low.y + d.size.y * worlds::uniform(random, 0.0, 1.0)},
          worlds::uniform(random, -turn, turn)};
}

TEST(PlannerSegments, CertifiedMotionsAreFree) {
  int certified = 0;
  int refused_free = 0;
  int refused = 0;
  const std::vector<worlds::Recipe> recipes = worlds::recipes();
  for (std::uint64_t seed = 0; seed < 45; ++seed) {
    SCOPED_TRACE(seed);
    Random random(40 + seed);
    World world(worlds::random_scene(random, recipes[seed % recipes.size()]));
    planner::SegmentTest test(world.problem, world.labeller, world.statistics);
    for (int i = 0; i < 60; ++i) {
      const double turn = i % 4 == 0 ? 12.0 : i % 4 == 1 ? 1e4 : 2.0;
      const ScaledConfiguration from = random_pose(random, world, turn);
      if (world.oracle.separation(point_at(from, from, 0)) <= 0) continue;
      ScaledConfiguration to = random_pose(random, world, turn);
      if (i % 4 == 1) to.theta = from.theta + worlds::uniform(random, -3.0, 3.0);
      if (i % 3 != 0) {  // short ones are free more often
        const double scale = std::exp(worlds::uniform(random, -6.0, -0.5));
        to = {from.t + scale * (to.t - from.t), from.theta + scale * (to.theta - from.theta)};
      }
      if (i % 10 == 9) to.t = from.t;  // turning only
      if (i % 10 == 8) to.theta = from.theta;
      const bool yes = test.certify(from, to);
      const Real least = least_along(world, from, to, 80);
      if (yes) {
        ++certified;
        ASSERT_GT(least, 0.0L) << "FALSE CERTIFICATE " << i;
      } else {
        ++refused;
        refused_free += least > 1e-9L;
      }
    }
  }
  EXPECT_GT(certified, 250);
  EXPECT_GT(refused, 150);
  EXPECT_LT(refused_free,
            refused / 20);  // samples may miss a collision; the test itself hardly ever
}

TEST(PlannerSegments, LeastClearanceIsATrueBoundAndMarginsAreKept) {
  int checked = 0;
  int kept = 0;
  const std::vector<worlds::Recipe> recipes = worlds::recipes();
  for (std::uint64_t seed = 0; seed < 45; ++seed) {
    SCOPED_TRACE(seed);
    Random random(140 + seed);
    worlds::Recipe recipe = recipes[seed % recipes.size()];
    World world(worlds::random_scene(random, recipe));
    planner::SegmentTest test(world.problem, world.labeller, world.statistics);
    for (int i = 0; i < 30; ++i) {
      const ScaledConfiguration from = random_pose(random, world, 3.0);
      ScaledConfiguration to = random_pose(random, world, 3.0);
      const double scale = std::exp(worlds::uniform(random, -5.0, -0.5));
      to = {from.t + scale * (to.t - from.t), from.theta + scale * (to.theta - from.theta)};
      if (!test.certify(from, to)) continue;
      ++checked;
      const planner::ClearanceBounds clearance =
          planner::bound_clearance(world.problem, world.tree, {from, to}, 0.05, 4000);
      const Real distance = least_along(world, from, to, 60, true);
      ASSERT_GT(clearance.lower, 0.0);
      ASSERT_LE(clearance.lower, static_cast<double>(distance) + 1e-12);
      const Real axes = least_along(world, from, to, 60);
      ASSERT_GE(clearance.lower, 0.94 * static_cast<double>(axes) - 1e-12);
      // A margin is kept: what is certified with it has that much separation.
      const double margin = static_cast<double>(axes) * worlds::uniform(random, 0.3, 1.7);
      if (test.certify(from, to, margin)) {
        ASSERT_GE(static_cast<double>(distance), margin * (1.0 - 1e-12));
        ++kept;
      }
    }
  }
  EXPECT_GT(checked, 200);
  EXPECT_GT(kept, 50);
}

// One configuration: free exactly when the oracle says so, beyond rounding.
TEST(PlannerSegments, SingleConfigurations) {
  int free = 0;
  int decided = 0;
  const std::vector<worlds::Recipe> recipes = worlds::recipes();
  for (std::uint64_t seed = 0; seed < 45; ++seed) {
    Random random(240 + seed);
    World world(worlds::random_scene(random, recipes[seed % recipes.size()]));
    planner::SegmentTest test(world.problem, world.labeller, world.statistics);
    for (int i = 0; i < 60; ++i) {
      const ScaledConfiguration q = random_pose(random, world, i % 2 == 0 ? 3.0 : 1e6);
      const Real separation = world.oracle.separation(point_at(q, q, 0));
      if (std::abs(separation) < 1e-7L) continue;
      ++decided;
      free += separation > 0;
      ASSERT_EQ(test.is_free(q), separation > 0) << seed << " " << i;
    }
  }
  EXPECT_GT(decided, 2500);
  EXPECT_GT(free, 500);
}

}  // namespace
