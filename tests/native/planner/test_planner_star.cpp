// STAR cells and links between solid cells: what is promised about guards and connectors, against
// dense long-double samples.
#include <gtest/gtest.h>

#include "planar_planner/native/cells/face.hpp"
#include "planner_worlds.hpp"

namespace {

using planner::CellId;
using planner::Label;
using planner::LinkState;
using worlds::Random;
using worlds::Real;
using worlds::World;

// Splits MIXED leaves, mostly the latest, so that cells of many sizes appear.
void grow(Random& random, planner::Subdivision& subdivision, const int rounds) {
  for (int round = 0; round < rounds; ++round) {
    std::vector<CellId> mixed;
    for (CellId id = 0; id < subdivision.size(); ++id)
      if (subdivision.cell(id).label == Label::kMixed) mixed.push_back(id);
    if (mixed.empty()) return;
    const auto latest = static_cast<int>(mixed.size()) - 1;
    subdivision.split(mixed[static_cast<std::size_t>(
        worlds::pick(random, 0, 2) == 0 ? latest : worlds::pick(random, 0, latest))]);
  }
}

Real angle_of(const planner::CellSpace& space, const std::uint64_t turns) {
  return space.rotation
             ? worlds::kFullTurn *
                   std::ldexp(static_cast<Real>(turns), -static_cast<int>(planner::kCoordinateBits))
             : Real{space.fixed_theta};
}

// The least separation on the straight way between two configurations.
Real least_between(const World& world, const worlds::Point& p, const worlds::Point& q,
                   const int steps) {
  Real least = INFINITY;
  for (int i = 0; i <= steps; ++i)
    least = std::min(least, world.oracle.separation(p + static_cast<Real>(i) / steps * (q - p)));
  return least;
}

// A connector may be written with the full turn for zero.
worlds::Point near(const worlds::Point& q, const Real theta) {
  worlds::Point out = q;
  out.theta += worlds::kFullTurn * std::round((theta - q.theta) / worlds::kFullTurn);
  return out;
}

TEST(PlannerStar, EveryFreeSampleSeesTheGuard) {
  int cells = 0;
  int seen = 0;
  int blocked_samples = 0;
  const std::vector<worlds::Recipe> recipes = worlds::recipes();
  for (std::uint64_t seed = 0; seed < 54; ++seed) {
    SCOPED_TRACE(seed);
    Random random(300 + seed);
    worlds::Recipe recipe = recipes[seed % recipes.size()];
    recipe.rotation = seed % 8 != 7;
    World world(worlds::random_scene(random, recipe), 0.7);
    planner::Subdivision subdivision(world.space, world.labeller, world.statistics);
    grow(random, subdivision, 150);
    for (CellId id = 0; id < subdivision.size(); ++id) {
      if (subdivision.cell(id).label != Label::kStar || worlds::pick(random, 0, 2) != 0) continue;
      ++cells;
      const worlds::Box box =
          worlds::box_of(world.space, planner::extent_of(subdivision.cell(id).box));
      const planner::Vec2 g = subdivision.guard(id);
      const worlds::Point guard{g.x, g.y, angle_of(world.space, subdivision.guard_turns(id))};
      ASSERT_GT(world.oracle.separation(guard), 0.0L) << "the guard is not free";
      ASSERT_GE(guard.x, box.low.x - 1e-15L);
      ASSERT_LE(guard.x, box.low.x + box.size.x + 1e-15L);
      ASSERT_GE(guard.y, box.low.y - 1e-15L);
      ASSERT_LE(guard.y, box.low.y + box.size.y + 1e-15L);
      for (int i = 0; i < 12; ++i) {
        const auto place = worlds::random_place(random);
        const worlds::Point q = box.at(place[0], place[1], place[2]);
        const Real here = world.oracle.separation(q);
        if (here < 0.0L) {
          ++blocked_samples;
          continue;
        }
        ++seen;
        // Rounding of the oracle only: the segment's ends are free.
        ASSERT_GT(least_between(world, guard, q, 24), -1e-16L) << "cell " << id;
      }
    }
  }
  EXPECT_GT(cells, 200);
  EXPECT_GT(seen, 1000);
  EXPECT_GT(blocked_samples, 500);  // the cells were not simply free
}

TEST(PlannerStar, LinksAreWhatTheyClaim) {
  int open = 0;
  int blocked = 0;
  const std::vector<worlds::Recipe> recipes = worlds::recipes();
  for (std::uint64_t seed = 0; seed < 54; ++seed) {
    SCOPED_TRACE(seed);
    Random random(700 + seed);
    worlds::Recipe recipe = recipes[seed % recipes.size()];
    recipe.rotation = seed % 8 != 7;
    recipe.obstacles += seed % 2 == 0 ? 6 : 0;
    World world(worlds::random_scene(random, recipe), 0.7);
    planner::Subdivision subdivision(world.space, world.labeller, world.statistics);
    grow(random, subdivision, 200);
    planner::FaceTest faces(subdivision, world.labeller, world.statistics);
    for (CellId a = 0; a < subdivision.size(); ++a) {
      const planner::Cell& cell = subdivision.cell(a);
      if (cell.label != Label::kStar) continue;
      for (const CellId b : cell.neighbours) {
        if (!subdivision.cell(b).solid() || (b < a && subdivision.cell(b).label == Label::kStar))
          continue;
        const planner::Link link = faces.test(a, b);
        if (link.state == LinkState::kDoubtful) continue;
        planner::Axis axis = planner::kNoAxis;
        ASSERT_TRUE(planner::adjacent(cell.box, subdivision.cell(b).box, axis));
        const planner::Extent face = planner::common_face(cell.box, subdivision.cell(b).box, axis);
        const worlds::Box box = worlds::box_of(world.space, face);
        if (link.state == LinkState::kBlocked) {
          ++blocked;
          const Real most = -worlds::least_in(
              random, box, 3, [&](const worlds::Point& q) { return -world.oracle.separation(q); });
          ASSERT_LT(most, 0.0L) << "FALSE BLOCKED FACE " << a << " " << b;
          continue;
        }
        if (worlds::pick(random, 0, 9) != 0) continue;
        ++open;
        const worlds::Point connector{link.connector.t.x, link.connector.t.y,
                                      angle_of(world.space, link.connector.turns)};
        ASSERT_GT(world.oracle.separation(connector), 0.0L);
        // On the closed face, up to the rounding of its coordinates.
        const worlds::Point on_face = near(connector, box.low.theta);
        ASSERT_GE(on_face.x, box.low.x - 1e-15L);
        ASSERT_LE(on_face.x, box.low.x + box.size.x + 1e-15L);
        ASSERT_GE(on_face.y, box.low.y - 1e-15L);
        ASSERT_LE(on_face.y, box.low.y + box.size.y + 1e-15L);
        ASSERT_GE(on_face.theta, box.low.theta - 1e-17L);
        ASSERT_LE(on_face.theta, box.low.theta + box.size.theta + 1e-17L);
        for (const CellId side : {a, b}) {
          if (subdivision.cell(side).label != Label::kStar) continue;
          const planner::Vec2 g = subdivision.guard(side);
          const Real theta = angle_of(world.space, subdivision.guard_turns(side));
          ASSERT_GT(least_between(world, {g.x, g.y, theta}, near(connector, theta), 24), -1e-14L);
        }
      }
    }
  }
  EXPECT_GT(open, 100);
  EXPECT_GT(blocked, 30);
}

}  // namespace
