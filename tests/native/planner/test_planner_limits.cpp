// A search sees time and limits only as they are handed to it.
#include <gtest/gtest.h>

#include "planar_planner/native/cells/face.hpp"
#include "planar_planner/native/paths/segment.hpp"
#include "planar_planner/native/search/search.hpp"
#include "planner_worlds.hpp"

namespace {

using planner::StopReason;
using planner::Verdict;

pdg::Polygon square(const double x, const double y, const double half) {
  return {
      {{{x - half, y - half}, {x + half, y - half}, {x + half, y + half}, {x - half, y + half}}}};
}

// A unit square, an obstacle between start and goal, and a box about them.
planner::Problem room() {
  planner::Problem scene;
  scene.robot.append(square(0, 0, 0.5));
  scene.obstacles.append(square(5, 5, 1.0));
  scene.box = planner::Rectangle{{0, 0}, {10, 10}};
  return scene;
}

// A search whose clock goes on by one second at every look, and that `check` may end.
struct Searched {
  explicit Searched(planner::LimitCheck check)
      : query(
            {2, 2, 0}, goal, nullptr, limits, [this] { return static_cast<double>(looks++); },
            std::move(check)) {
    planner::Search(world.problem, world.tree, subdivision, faces, segments, world.statistics,
                    query)
        .run();
  }

  planner::Goal goal{planner::Configuration{8, 8, 1}};
  worlds::World world{room()};
  planner::Limits limits;
  planner::SegmentTest segments{world.problem, world.labeller, world.statistics};
  planner::Subdivision subdivision{world.space, world.labeller, world.statistics,
                                   planner::crossing_cost};
  planner::FaceTest faces{subdivision, world.labeller, world.statistics};
  int looks = 0;
  planner::Query query;
};

TEST(PlannerLimits, ClockThatIsHandedInIsTheOnlyOne) {
  const Searched run([](const auto&, const auto&) { return std::nullopt; });
  EXPECT_EQ(run.query.answer.verdict, Verdict::kPath);
  EXPECT_FALSE(run.query.stopped_by.has_value());
  const planner::Seconds& s = run.world.statistics.seconds;
  EXPECT_EQ(s.preprocessing + s.probe + s.total, 0.0);
  EXPECT_GT(s.labelling, 0.0);
  EXPECT_GT(s.search, 0.0);
  // Each stopwatch looks twice; one that holds no other adds a second.
  EXPECT_GE(s.labelling + s.faces + s.search + s.path, 0.5 * run.looks);
}

TEST(PlannerLimits, SearchEndsWhenItIsToldToAndSaysWhy) {
  for (const StopReason reason : {StopReason::kTimeout, StopReason::kInterrupted})
    for (const int last : {1, 2, 5}) {
      int asked = 0;
      planner::Progress seen;
      planner::Usage used;
      const Searched run([&](const planner::Usage& usage, const auto& progress) {
        used = usage;
        seen = progress();
        return ++asked < last ? std::optional<StopReason>() : reason;
      });
      EXPECT_EQ(asked, last);
      EXPECT_EQ(run.query.answer.verdict, Verdict::kUndecided);
      EXPECT_EQ(run.query.answer.stop_reason, reason);
      EXPECT_EQ(run.query.stopped_by, reason);
      EXPECT_EQ(used.cells, run.subdivision.size());
      EXPECT_EQ(seen.cells, used.cells);
      EXPECT_EQ(seen.free + seen.star + seen.full + seen.mixed, seen.cells);
      EXPECT_EQ(seen.elapsed, 0.0);
    }
}

}  // namespace
