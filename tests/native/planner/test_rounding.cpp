// Cases in which rounding once led, or could have led, to a false answer. Each failed before its
// fix; the harness in rounding/ looks for others.
#include <gtest/gtest.h>

#include <numbers>

#include "pdg/native/separation/c_obstacle_query.hpp"
#include "planar_planner/native/planning/planner.hpp"

namespace {

using planner::Vec2;

pdg::Polygon rectangle(const Vec2 low, const Vec2 high) {
  return {{{low, {high.x, low.y}, high, {low.x, high.y}}}};
}

// The robot's origin is half a unit beyond the tip of a sliver 1e-16 thick: within rounding of both
// its long sides, and yet far outside. It was taken to be inside, so that the domain ended at the
// workspace although the robot goes where its origin is outside: a false "no path".
TEST(Rounding, OriginBeyondTheTipOfASliver) {
  planner::Problem scene;
  scene.rotation = false;
  scene.robot.append({{{{-0x1.399f8f8ba0b49p-2, -0x1.92e4b7a5744dp-2},
                        {-0x1.d75010068d95fp-1, -0x1.2ebbe19ca29a1p+0},
                        {-0x1.d75010068d95ep-1, -0x1.2ebbe19ca29a1p+0}}}});
  scene.box = planner::Rectangle{{0.0, 0.0}, {1.0, 10.0}};
  scene.obstacles.append(rectangle({-0.5, 4.9}, {0.2, 5.1}));
  planner::Planner planner(scene);
  EXPECT_EQ(planner.solve({0.93, 2.0, 0.0}, planner::Configuration{0.93, 8.0, 0.0}, {}, {}).verdict,
            planner::Verdict::kPath);
}

// At an angle whose units in the last place are whole radians, a cell of every orientation is cut
// into stretches whose centres cannot be told apart: they were widened beyond a quarter turn, where
// the ranges' formulas no longer hold.
TEST(Rounding, QueryOfEveryOrientationAtAHugeAngle) {
  const pdg::PieceSet bar =
      pdg::make_piece_set({{{0.0, -0.1}, {4.0, -0.1}, {4.0, 0.1}, {0.0, 0.1}}});
  const pdg::PieceSet block =
      pdg::make_piece_set({{{1.0, -1.0}, {3.0, -1.0}, {3.0, 1.0}, {1.0, 1.0}}});
  for (int power = 0; power < 500; ++power) {
    for (const double half : {1.6, 2.0, 3.2, 10.0}) {
      const pdg::Cell cell{{{0.0, 0.0}, std::ldexp(1.0, power)}, {0.0, 0.0, half}};
      const auto verdict = pdg::c_obstacle_query(bar, block, cell, pdg::QueryMethod::kPerNormal);
      // The bar misses the block when it points away from it: within 1.6 of any angle it does, or
      // at least it points upwards, where it misses it too.
      EXPECT_FALSE(verdict.full) << power << ' ' << half;
    }
  }
}

}  // namespace
