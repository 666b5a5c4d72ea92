// Queries whose answer is known by hand: ends in one leaf, tiny and wrapped domains, limits.
#include <gtest/gtest.h>

#include "planar_planner/native/planning/planner.hpp"
#include "planner_worlds.hpp"

namespace {

using planner::Answer;
using planner::Configuration;
using planner::Limits;
using planner::Planner;
using planner::Problem;
using planner::Verdict;

pdg::Polygon box(const double x, const double y, const double half_x, const double half_y) {
  return {{{{x - half_x, y - half_y},
            {x + half_x, y - half_y},
            {x + half_x, y + half_y},
            {x - half_x, y + half_y}}}};
}

// A square of side 1 in a box of 10 by 10, in the user's `unit`.
Problem room(const double unit = 1.0) {
  Problem scene;
  scene.robot.append(box(0, 0, 0.5 * unit, 0.5 * unit));
  scene.box = planner::Rectangle{{0, 0}, {10 * unit, 10 * unit}};
  return scene;
}

Answer solve(Planner& planner, const Configuration& start, const Configuration& goal,
             const Limits& limits = {.max_cells = 20'000}) {
  return planner.solve(start, goal, limits, {});
}

void expect_path_between(Planner& planner, const Answer& answer, const Configuration& start,
                         const Configuration& goal) {
  ASSERT_EQ(answer.verdict, Verdict::kPath);
  const auto& path = answer.path.waypoints;
  ASSERT_GE(path.size(), 2U);
  EXPECT_EQ(path.front().x, start.x);
  EXPECT_EQ(path.front().y, start.y);
  EXPECT_EQ(path.front().theta, start.theta);
  EXPECT_EQ(path.back().x, goal.x);
  EXPECT_EQ(path.back().y, goal.y);
  EXPECT_LT(planner.check_path(path).bad_segment, 0);
  EXPECT_GT(planner.least_clearance(), 0.0);
}

TEST(PlannerSmall, StartIsGoal) {
  Planner planner(room());
  const Configuration q{3, 4, 1.0};
  const Answer answer = solve(planner, q, q);
  expect_path_between(planner, answer, q, q);
  EXPECT_EQ(answer.path.length, 0.0);
  EXPECT_EQ(answer.path.turning, 0.0);
}

TEST(PlannerSmall, WholeTurnsAreTheSameConfiguration) {
  Planner planner(room());
  const Configuration start{3, 4, 1.0};
  const Configuration goal{3, 4, 1.0 + 20 * std::numbers::pi};
  const Answer answer = solve(planner, start, goal);
  expect_path_between(planner, answer, start, goal);
  EXPECT_LT(answer.path.turning, 1e-13);
}

TEST(PlannerSmall, GoesTheShortWayRoundThroughZero) {
  Planner planner(room());
  const Answer answer = solve(planner, {3, 4, 0.1}, {6, 4, 2 * std::numbers::pi - 0.1});
  ASSERT_EQ(answer.verdict, Verdict::kPath);
  EXPECT_NEAR(answer.path.turning, 0.2, 1e-12);
}

TEST(PlannerSmall, HugeAnglesNearAWall) {
  for (const double theta : {7636351133.241347, -2818073365.028727, 1e15}) {
    Planner planner(room());
    const double extent = 0.5 * (std::abs(std::cos(theta)) + std::abs(std::sin(theta)));
    for (const double gap : {1e-8, 1e-7, 1e-3, 1.0}) {
      const Configuration start{extent + gap, extent + gap, theta};
      EXPECT_NE(solve(planner, start, {5, 5, theta}).verdict, Verdict::kNoPath)
          << theta << " " << gap;
    }
  }
}

TEST(PlannerSmall, TinyAndHugeUnitsAnswerAlike) {
  for (const int exponent : {0, -100, 100, -200, 200}) {
    const double unit = std::ldexp(1.0, exponent);
    Problem scene = room(unit);
    scene.obstacles.append(box(5 * unit, 3 * unit, 0.5 * unit, 3 * unit));
    scene.obstacles.append(box(5 * unit, 9.25 * unit, 0.5 * unit, 1.25 * unit));
    Planner planner(std::move(scene));
    const Configuration start{2 * unit, 2 * unit, 0};
    const Configuration goal{8 * unit, 2 * unit, 0};
    const Answer answer = solve(planner, start, goal);
    ASSERT_NO_FATAL_FAILURE(expect_path_between(planner, answer, start, goal)) << exponent;
  }
}

TEST(PlannerSmall, DomainThatJustHoldsTheRobot) {
  Problem scene;
  scene.robot.append(box(0, 0, 0.5, 0.5));
  scene.box = planner::Rectangle{{0, 0}, {1.001, 1.001}};
  Planner planner(std::move(scene));
  const Configuration start{0.5003, 0.5007, 0};
  const Configuration goal{0.5007, 0.5003, 0};
  expect_path_between(planner, solve(planner, start, goal), start, goal);
  // A quarter turn needs a diagonal of room.
  const Answer turned = solve(planner, start, {0.5005, 0.5005, 0.5 * std::numbers::pi});
  EXPECT_EQ(turned.verdict, Verdict::kNoPath);
}

TEST(PlannerSmall, ReferencePointFarOffTheBody) {
  Problem scene;
  scene.robot.append(box(100, 0, 0.5, 0.5));
  scene.box = planner::Rectangle{{0, 0}, {10, 10}};
  scene.obstacles.append(box(5, 3, 0.5, 3));
  Planner planner(std::move(scene));
  const Configuration start{-98, 2, 0};
  const Configuration goal{-92, 2, 0};
  expect_path_between(planner, solve(planner, start, goal), start, goal);
  EXPECT_EQ(solve(planner, {2, 2, 0}, goal).verdict, Verdict::kNoPath);  // the body is outside
}

TEST(PlannerSmall, ReferenceBoundsBindTheReferencePointOnly) {
  Problem scene;
  scene.robot.append(box(0, 0, 0.5, 0.5));
  scene.reference_bounds = planner::Rectangle{{0, 0}, {10, 10}};
  scene.obstacles.append(box(5, 5, 0.5, 5.4));  // from -0.4 to 10.4: no way past it
  Planner planner(scene);
  EXPECT_EQ(solve(planner, {0, 0, 0}, {10, 10, 0}).verdict, Verdict::kNoPath);
  EXPECT_EQ(solve(planner, {0, -1e-9, 0}, {10, 10, 0}).verdict, Verdict::kNoPath);
  EXPECT_GE(planner.check_path({{0, 0, 0}, {0, -1e-9, 0}}).bad_segment, 0);
  scene.obstacles = {};
  scene.obstacles.append(box(5, 5, 0.5, 4.4));  // from 0.6 to 9.4: past it along the bounds
  Planner open(scene);
  const Configuration start{0, 0, 0};
  const Configuration goal{10, 10, 0};
  expect_path_between(open, solve(open, start, goal), start, goal);
  const Configuration level_start{0, 5, 0};
  const Configuration level_goal{10, 5, 0};
  const Answer answer = solve(open, level_start, level_goal);
  expect_path_between(open, answer, level_start, level_goal);
  for (const Configuration& q : answer.path.waypoints) {
    EXPECT_GE(q.y, 0.0);
    EXPECT_LE(q.y, 10.0);
  }
}

TEST(PlannerSmall, FixedAngleIsTheQuerysOwn) {
  Problem scene = room();
  scene.rotation = false;
  scene.obstacles.append(box(5, 2.25, 0.5, 2.25));
  scene.obstacles.append(box(5, 8, 0.5, 2));  // a gap of 1.5: wide enough at every angle
  Planner planner(std::move(scene));
  const double quarter = 0.5 * std::numbers::pi;
  for (const double theta : {0.0, 0.3, quarter, 0.0}) {
    const Configuration start{2, 2, theta};
    const Configuration goal{8, 2, theta};
    const Answer answer = solve(planner, start, goal);
    ASSERT_NO_FATAL_FAILURE(expect_path_between(planner, answer, start, goal)) << theta;
    for (const Configuration& q : answer.path.waypoints) EXPECT_EQ(q.theta, theta);
  }
}

TEST(PlannerSmall, FixedAngleDecidesTheVerdict) {
  Problem scene;
  scene.robot.append(box(0, 0, 1.0, 0.2));  // a bar
  scene.box = planner::Rectangle{{0, 0}, {10, 10}};
  scene.obstacles.append(box(5, 2.25, 0.5, 2.25));
  scene.obstacles.append(box(5, 7.75, 0.5, 2.25));  // a gap of 1
  scene.rotation = false;
  Planner planner(scene);
  const double quarter = 0.5 * std::numbers::pi;
  // In turn, on one planner: the cells of one angle must not answer for another.
  for (int i = 0; i < 2; ++i) {
    EXPECT_EQ(solve(planner, {2, 2, 0}, {8, 2, 0}).verdict, Verdict::kPath);
    EXPECT_EQ(solve(planner, {2, 2, quarter}, {8, 2, quarter}).verdict, Verdict::kNoPath);
  }
  scene.rotation = true;
  Planner turning(scene);
  EXPECT_EQ(solve(turning, {2, 2, quarter}, {8, 2, quarter}).verdict, Verdict::kPath);
}

TEST(PlannerSmall, ExactlyAsWideAsTheGap) {
  // Touching is allowed. Cells can neither certify nor refute a passage of no width; exact
  // arithmetic passes it, and refutes one that is narrower by one unit in the last place.
  Problem scene = room();
  scene.rotation = false;
  scene.obstacles.append(box(5, 2.25, 0.5, 2.25));
  scene.obstacles.append(box(5, 7.75, 0.5, 2.25));
  const Limits limits{.max_cells = 5000};
  planner::Ablation cells_only;
  cells_only.layers = false;
  Planner by_cells(scene, cells_only);
  EXPECT_EQ(solve(by_cells, {2, 2, 0}, {8, 2, 0}, limits).verdict, Verdict::kUndecided);
  Planner planner(scene);
  EXPECT_EQ(solve(planner, {2, 2, 0}, {8, 2, 0}, limits).verdict, Verdict::kPath);
  scene.obstacles = {};
  const double up = std::nextafter(4.5, 5.0);
  scene.obstacles.append({{{{4.5, 0}, {5.5, 0}, {5.5, up}, {4.5, up}}}});
  scene.obstacles.append(box(5, 7.75, 0.5, 2.25));
  Planner narrower(scene);
  EXPECT_EQ(solve(narrower, {2, 2, 0}, {8, 2, 0}, limits).verdict, Verdict::kNoPath);
  scene.obstacles = {};
  scene.obstacles.append(box(5, 2.25 - 1e-9, 0.5, 2.25));
  scene.obstacles.append(box(5, 7.75, 0.5, 2.25));
  Planner wider(scene);
  EXPECT_NE(solve(wider, {2, 2, 0}, {8, 2, 0}, limits).verdict, Verdict::kNoPath);
}

TEST(PlannerSmall, LimitsNeverProveAnything) {
  Problem scene = room();
  scene.obstacles.append(box(5, 2, 0.5, 2.4));
  scene.obstacles.append(box(5, 8, 0.5, 2.4));  // a gap of 1.2 for a square of 1
  const Configuration start{2, 2, 0.5};
  const Configuration goal{8, 2, 2.5};
  const auto verdict = [&](const Limits& limits) {
    Planner planner(scene);
    return solve(planner, start, goal, limits).verdict;
  };
  EXPECT_EQ(verdict({}), Verdict::kPath);
  for (const double resolution : {1.0, 0.1, 0.03, 0.01, 0.003})
    EXPECT_NE(verdict({.resolution = resolution}), Verdict::kNoPath) << resolution;
  for (const std::uint64_t cells : {1, 4, 5, 10, 50, 100})
    EXPECT_NE(verdict({.max_cells = cells}), Verdict::kNoPath) << cells;
  EXPECT_NE(verdict({.timeout = 1e-9}), Verdict::kNoPath);
  EXPECT_NE(verdict({.max_memory = 1000}), Verdict::kNoPath);
  Planner planner(scene);
  const planner::Listener refuse = [](const planner::Progress&) { return false; };
  EXPECT_NE(planner.solve(start, goal, {}, refuse).verdict, Verdict::kNoPath);
  // What a stopped query left behind serves the next one.
  planner::Ablation cells_only;
  cells_only.probe = false;
  Planner by_cells(scene, cells_only);
  EXPECT_EQ(solve(by_cells, start, goal, {.max_cells = 20}).verdict, Verdict::kUndecided);
  EXPECT_EQ(solve(by_cells, start, goal).verdict, Verdict::kPath);
}

}  // namespace
