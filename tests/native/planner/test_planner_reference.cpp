// Points of the body in place of far origins: exact shifts, and ways of the origin whose body keeps
// free, against dense samples in long double.
#include <gtest/gtest.h>

#include <cmath>

#include "planar_planner/native/configurations/reference_point.hpp"
#include "planar_planner/native/paths/segment.hpp"
#include "planar_planner/native/planning/reference_path.hpp"
#include "planner_worlds.hpp"

namespace {

using planner::Configuration;
using planner::Vec2;
using worlds::Random;
using worlds::Real;
using worlds::World;

planner::PolygonSet blob(Random& random, const Vec2 at, const double radius) {
  planner::Polygon polygon{{{}}};
  for (int i = 0; i < 7; ++i) {
    const double angle = 2 * M_PI * (i + worlds::uniform(random, 0.0, 0.8)) / 7;
    const double r = radius * worlds::uniform(random, 0.3, 1.0);
    polygon.rings[0].push_back({at.x + r * std::cos(angle), at.y + r * std::sin(angle)});
  }
  planner::PolygonSet set;
  set.append(polygon);
  return set;
}

TEST(PlannerReference, ShiftsAreExactAndLeadToTheBody) {
  Random random(1);
  int shifted = 0;
  for (int i = 0; i < 2000; ++i) {
    const double far = std::exp(worlds::uniform(random, -2.0, 14.0));
    const double angle = worlds::uniform(random, 0.0, 7.0);
    const Vec2 at{far * std::cos(angle), i % 3 == 0 ? 0.0 : far * std::sin(angle)};
    const planner::PolygonSet robot = blob(random, at, 1.0);
    const auto point = planner::body_point(robot);
    if (!point) {
      EXPECT_LT(std::hypot(at.x, at.y), 3.0);
      continue;
    }
    ++shifted;
    const planner::PolygonSet about = planner::about_point(robot, *point);
    for (std::size_t k = 0; k < robot.points.size(); ++k) {
      const Vec2 a = robot.points[k];
      const Vec2 b = about.points[k];
      ASSERT_EQ(Real{b.x}, Real{a.x} - Real{point->x});
      ASSERT_EQ(Real{b.y}, Real{a.y} - Real{point->y});
      // Along an axis near whose 0 the body lies the origin may stay.
      EXPECT_LT(std::hypot(b.x, b.y), 6.0);
    }
  }
  EXPECT_GT(shifted, 1500);
}

TEST(PlannerReference, AnOriginInTheBodyStays) {
  Random random(2);
  for (int i = 0; i < 200; ++i) EXPECT_FALSE(planner::body_point(blob(random, {}, 1.0)));
}

// Where the point of the frame is, in planner units and long double.
worlds::Point place(const planner::ScaledProblem& problem, const Vec2 point, const Configuration& a,
                    const Configuration& b, const Real s) {
  const auto along = [&](const double from, const double to) {
    return Real{from} + s * (Real{to} - Real{from});
  };
  const Real theta = along(a.theta, b.theta);
  const Real c = std::cos(theta);
  const Real n = std::sin(theta);
  const Real unit = std::ldexp(Real{1}, problem.frame.exponent);
  return {(along(a.x, b.x) + c * point.x - n * point.y - problem.frame.origin.x) * unit,
          (along(a.y, b.y) + n * point.x + c * point.y - problem.frame.origin.y) * unit, theta};
}

TEST(PlannerReference, WaysOfFarOriginsKeepTheBodyFree) {
  int ways = 0;
  std::size_t waypoints = 0;
  const std::vector<worlds::Recipe> recipes = worlds::recipes();
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    SCOPED_TRACE(seed);
    Random random(300 + seed);
    World world(worlds::random_scene(random, recipes[seed % recipes.size()]));
    if (!world.problem.rotation || world.problem.reference_bounds) continue;
    planner::SegmentTest test(world.problem, world.labeller, world.statistics);
    for (int i = 0; i < 40; ++i) {
      const planner::Domain& d = world.problem.domain;
      const auto pose = [&] {
        const Vec2 t{d.low.x + d.size.x * worlds::uniform(random, 0.0, 1.0),
                     d.low.y + d.size.y * worlds::uniform(random, 0.0, 1.0)};
        return planner::configuration_of(world.problem, {t, worlds::uniform(random, -2.0, 2.0)});
      };
      const std::vector<Configuration> path{pose(), pose()};
      if (!test.certify(scaled(world.problem, path[0]), scaled(world.problem, path[1]))) continue;
      const double far = std::exp(worlds::uniform(random, 0.0, 10.0));
      const Vec2 point{far, worlds::uniform(random, -far, far)};
      const auto way = planner::reference_path(
          world.problem, test, point, path, planner::placed_back(point, path[0]),
          planner::placed_back(point, path[1]), [] { return false; });
      if (!way) continue;
      ++ways;
      waypoints += way->size();
      for (std::size_t k = 0; k + 1 < way->size(); k += 1 + way->size() / 50)
        for (int s = 0; s <= 16; ++s)
          ASSERT_GT(world.oracle.separation(
                        place(world.problem, point, (*way)[k], (*way)[k + 1], s / Real{16})),
                    0.0L)
              << "FALSE CERTIFICATE " << i;
    }
  }
  EXPECT_GT(ways, 30);
  EXPECT_GT(waypoints, 1000U);
}

}  // namespace
