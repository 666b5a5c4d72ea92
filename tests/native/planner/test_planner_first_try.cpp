// The first try: its collision test against separating axes in long double, and what its trees
// promise.
#include <gtest/gtest.h>

#include <set>

#include "planar_planner/native/guesses/rrt_connect.hpp"
#include "planar_planner/native/paths/collision.hpp"
#include "planar_planner/native/planning/planner.hpp"
#include "planner_worlds.hpp"

namespace {

using planner::CollisionHint;
using planner::Configuration;
using planner::RrtConnect;
using planner::ScaledConfiguration;
using worlds::Random;
using worlds::Real;
using worlds::World;

// Planner units; nearer to contact plain doubles may say either.
constexpr Real kBeyondRounding = 1e-12L;
constexpr std::uint64_t kWork = 2'000'000;      // some thousand questions
constexpr std::uint64_t kMostAtOnce = 200'000;  // of one question and one walk to the nearest
constexpr double kSpacing = 0.02;

const planner::Terminator never = [] { return false; };

ScaledConfiguration random_pose(Random& random, const planner::Domain& domain) {
  return {{domain.low.x + worlds::uniform(random, -0.02, 1.02) * domain.size.x,
           domain.low.y + worlds::uniform(random, -0.02, 1.02) * domain.size.y},
          worlds::uniform(random, -10.0, 10.0)};
}

bool in_domain(const planner::Domain& domain, const ScaledConfiguration& pose) {
  const pdg::Vec2 p = pose.t - domain.low;
  return p.x >= 0.0 && p.y >= 0.0 && p.x <= domain.size.x && p.y <= domain.size.y;
}

// `small`: obstacle vertices up to which pieces are asked, not outlines.
void compare_with_oracle(const std::size_t small) {
  int free = 0;
  int colliding = 0;
  const std::vector<worlds::Recipe> recipes = worlds::recipes();
  for (std::uint64_t seed = 0; seed < 45; ++seed) {
    SCOPED_TRACE(seed);
    Random random(7700 + seed);
    World world(worlds::random_scene(random, recipes[seed % recipes.size()]));
    CollisionHint hint(world.problem, world.tree, small);
    for (int i = 0; i < 400; ++i) {
      const ScaledConfiguration pose = random_pose(random, world.problem.domain);
      const Real separation = world.oracle.separation({pose.t.x, pose.t.y, pose.theta});
      const bool collides = (hint.gap(pose) < 0.0);
      if (!in_domain(world.problem.domain, pose)) {
        ASSERT_TRUE(collides);
      } else if (std::abs(separation) > kBeyondRounding) {
        ASSERT_EQ(collides, separation < 0.0L) << static_cast<double>(separation);
        ++(collides ? colliding : free);
      }
    }
    ASSERT_EQ(hint.calls(), 400U);
    if (small == 0) {
      ASSERT_EQ(world.tree.untouched_polygons(), all_obstacles(world.problem).size());
    }
  }
  EXPECT_GT(free, 1000);
  EXPECT_GT(colliding, 1000);
}

TEST(PlannerFirstTry, CollisionsOfPiecesAgreeWithTheOracle) {
  compare_with_oracle(planner::kSmallScene);
}

TEST(PlannerFirstTry, CollisionsOfOutlinesAgreeWithTheOracleAndDecomposeNothing) {
  compare_with_oracle(0);
}

// No motion of the robot that is shorter than the gap meets anything.
TEST(PlannerFirstTry, GapsAreNeverTooLarge) {
  int moved = 0;
  const std::vector<worlds::Recipe> recipes = worlds::recipes();
  for (std::uint64_t seed = 0; seed < 36; ++seed) {
    SCOPED_TRACE(seed);
    Random random(9900 + seed);
    World world(worlds::random_scene(random, recipes[seed % recipes.size()]));
    CollisionHint hint(world.problem, world.tree, seed % 2 == 0 ? 0 : planner::kSmallScene);
    for (int i = 0; i < 400; ++i) {
      const ScaledConfiguration pose = random_pose(random, world.problem.domain);
      const double gap = hint.gap(pose);
      if (gap <= 0.0) continue;
      const double share = worlds::uniform(random, 0.0, 1.0);
      const double angle = worlds::uniform(random, 0.0, 6.3);
      const double turn = (1.0 - share) * gap / world.problem.robot.reach;
      const ScaledConfiguration there{
          pose.t + share * gap * pdg::Vec2{std::cos(angle), std::sin(angle)},
          pose.theta + (i % 2 == 0 ? turn : -turn)};
      const Real separation = world.oracle.separation({there.t.x, there.t.y, there.theta});
      ASSERT_GT(separation, -kBeyondRounding) << gap;
      ++moved;
    }
  }
  EXPECT_GT(moved, 500);
}

// Whatever was decomposed meanwhile is asked piece by piece.
TEST(PlannerFirstTry, OutlinesGiveWayToPieces) {
  Random random(1);
  World world(
      worlds::random_scene(random, {.obstacles = 6, .convex = false, .obstacle_size = 3.0}));
  CollisionHint outlines(world.problem, world.tree, 0);
  std::vector<ScaledConfiguration> poses;
  std::vector<bool> before;
  for (int i = 0; i < 500; ++i) {
    poses.push_back(random_pose(random, world.problem.domain));
    before.push_back(outlines.gap(poses.back()) < 0.0);
  }
  world.tree.expand_all();
  for (std::size_t i = 0; i < poses.size(); ++i) ASSERT_EQ(outlines.gap(poses[i]) < 0.0, before[i]);
}

std::optional<Configuration> free_place(World& world, CollisionHint& hint, Random& random) {
  for (int i = 0; i < 200; ++i) {
    const ScaledConfiguration pose = random_pose(random, world.problem.domain);
    if (!(hint.gap(pose) < 0.0)) return planner::configuration_of(world.problem, pose);
  }
  return std::nullopt;
}

void check_path(World& world, CollisionHint& hint, const std::vector<Configuration>& path) {
  for (std::size_t i = 0; i + 1 < path.size(); ++i) {
    const ScaledConfiguration a = planner::scaled(world.problem, path[i]);
    const ScaledConfiguration b = planner::scaled(world.problem, path[i + 1]);
    ASSERT_LE(std::abs(b.theta - a.theta), std::numbers::pi * (1.0 + 1e-9));
    const double way =
        pdg::norm(b.t - a.t) + world.problem.robot.reach * std::abs(b.theta - a.theta);
    const int steps = static_cast<int>(way / kSpacing);
    // As many places as the trees asked about at least, not the same ones: near misses are rare.
    int hits = 0;
    for (int k = 1; k < steps; ++k)
      hits += hint.gap(planner::between(a, b, static_cast<double>(k) / steps)) < 0.0 ? 1 : 0;
    ASSERT_LE(hits, 2);
  }
}

TEST(PlannerFirstTry, PathsRunFromStartToGoalWithinTheBudget) {
  int found = 0;
  const std::vector<worlds::Recipe> recipes = worlds::recipes();
  for (std::uint64_t seed = 0; seed < 36; ++seed) {
    SCOPED_TRACE(seed);
    Random random(8800 + seed);
    worlds::Recipe recipe = recipes[seed % recipes.size()];
    recipe.rotation = seed % 2 == 0;
    World world(worlds::random_scene(random, recipe));
    CollisionHint places(world.problem, world.tree);
    const auto start = free_place(world, places, random);
    auto goal = free_place(world, places, random);
    if (!start || !goal) continue;
    if (!recipe.rotation) {
      goal->theta = start->theta;
      if (places.gap(planner::scaled(world.problem, *goal)) < 0.0) continue;
    }
    CollisionHint hint(world.problem, world.tree);
    RrtConnect trees(world.problem, hint, *start, {&*goal, 1});
    const auto path = trees.find(kSpacing, kWork, never);
    ASSERT_LE(trees.work(), kWork + kMostAtOnce);
    CollisionHint second(world.problem, world.tree);
    const auto again =
        RrtConnect(world.problem, second, *start, {&*goal, 1}).find(kSpacing, kWork, never);
    ASSERT_EQ(hint.calls(), second.calls());
    ASSERT_EQ(path.size(), again.size());
    for (std::size_t i = 0; i < path.size(); ++i) {
      ASSERT_EQ(path[i].x, again[i].x);
      ASSERT_EQ(path[i].theta, again[i].theta);
      if (!recipe.rotation) {
        ASSERT_EQ(path[i].theta, start->theta);
      }
    }
    if (path.empty()) continue;
    ++found;
    ASSERT_EQ(path.front().x, start->x);
    ASSERT_EQ(path.front().theta, start->theta);
    ASSERT_EQ(path.back().y, goal->y);
    const double turns = (path.back().theta - goal->theta) / (2.0 * std::numbers::pi);
    ASSERT_NEAR(turns, std::nearbyint(turns), 1e-9);
    check_path(world, places, path);
  }
  EXPECT_GT(found, 15);
}

// What was rejected does not come back, and what is left still hangs together.
TEST(PlannerFirstTry, GoesOnWithoutARejectedSegment) {
  int again = 0;
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    SCOPED_TRACE(seed);
    Random random(9900 + seed);
    World world(worlds::random_scene(random, worlds::recipes()[seed % worlds::recipes().size()]));
    CollisionHint places(world.problem, world.tree);
    const auto start = free_place(world, places, random);
    const auto goal = free_place(world, places, random);
    if (!start || !goal || (!world.problem.rotation && start->theta != goal->theta)) continue;
    CollisionHint hint(world.problem, world.tree);
    RrtConnect trees(world.problem, hint, *start, {&*goal, 1});
    auto path = trees.find(kSpacing, kWork, never);
    for (int round = 0; round < 5 && !path.empty(); ++round) {
      const std::size_t segment = random() % (path.size() - 1);
      const planner::Configuration from = path[segment];
      const planner::Configuration to = path[segment + 1];
      trees.reject(segment);
      path = trees.find(kSpacing, kWork, never);
      if (path.empty()) break;
      ++again;
      check_path(world, places, path);
      for (std::size_t i = 0; i + 1 < path.size(); ++i) {
        EXPECT_FALSE(path[i].x == from.x && path[i].y == from.y && path[i + 1].x == to.x &&
                     path[i + 1].y == to.y);
      }
    }
  }
  EXPECT_GT(again, 30);
}

TEST(PlannerFirstTry, SpendsItsBudgetWhereThereIsNoWay) {
  planner::Problem scene;
  scene.robot.append({{{{-0.5, -0.5}, {0.5, -0.5}, {0.5, 0.5}, {-0.5, 0.5}}}});
  scene.obstacles.append({{{{4.0, -1.0}, {6.0, -1.0}, {6.0, 11.0}, {4.0, 11.0}}}});
  scene.box = planner::Rectangle{{0.0, 0.0}, {10.0, 10.0}};
  World world(std::move(scene));
  CollisionHint hint(world.problem, world.tree);
  const Configuration goal{8.0, 5.0, 0.0};
  RrtConnect trees(world.problem, hint, {2.0, 5.0, 0.0}, {&goal, 1});
  EXPECT_TRUE(trees.growing());
  EXPECT_TRUE(trees.find(kSpacing, kWork, never).empty());
  EXPECT_GE(trees.work(), kWork);
  EXPECT_LE(trees.work(), kWork + kMostAtOnce);
  // Goes on from there, until both rooms are full.
  EXPECT_TRUE(trees.find(kSpacing, 40 * kWork, never).empty());
  EXPECT_GE(trees.work(), 40 * kWork);
  EXPECT_FALSE(trees.growing());
}

TEST(PlannerFirstTry, StopsWhenTold) {
  Random random(3);
  World world(worlds::random_scene(random, {}));
  CollisionHint hint(world.problem, world.tree);
  const Configuration goal{1.0, 1.0, 1.0};
  const auto path =
      RrtConnect(world.problem, hint, {}, {&goal, 1}).find(kSpacing, kWork, [] { return true; });
  EXPECT_TRUE(path.empty());
  EXPECT_EQ(hint.calls(), 0U);
}

TEST(PlannerFirstTry, NearestNodesAreThoseOfAWalkOverAll) {
  Random random(11);
  constexpr double kHalf = 0.7;
  planner::NearestPoint places;
  std::vector<planner::RoundPoint> all;
  const auto distance = [&](const planner::RoundPoint& a, const planner::RoundPoint& b) {
    const pdg::Vec2 way = a.place - b.place;
    const double turn = std::remainder(a.turn - b.turn, 2.0 * kHalf);
    return dot(way, way) + turn * turn;
  };
  const auto point = [&](const int i) {
    // Many in a row and in the same place, too.
    const double x = i % 3 == 0 ? 0.25 : worlds::uniform(random, -1.0, 1.0);
    return planner::RoundPoint{{x, worlds::uniform(random, -1.0, 1.0)},
                               worlds::uniform(random, -kHalf, kHalf)};
  };
  std::uint64_t passed = 0;
  for (int i = 0; i < 3000; ++i) {
    all.push_back(i % 10 == 9 ? all.back() : point(i));
    places.add(all.back());
    const planner::RoundPoint asked = point(i + 1);
    const std::uint32_t found = places.nearest(asked, kHalf, passed);
    double least = INFINITY;
    for (const planner::RoundPoint& other : all) least = std::min(least, distance(other, asked));
    ASSERT_NEAR(distance(all[found], asked), least, 1e-15);
  }
  EXPECT_LT(passed, 3000U * 3000U / 8U);
}

TEST(PlannerFirstTry, SetsOfBoxesCountEachNumberOnce) {
  Random random(12);
  planner::BoxSet boxes;
  std::set<std::uint64_t> expected;
  for (int i = 0; i < 5000; ++i) {
    const std::uint64_t number = random() % 700 << (random() % 40);
    boxes.insert(number);
    expected.insert(number);
    ASSERT_EQ(boxes.size(), expected.size());
  }
}

}  // namespace
