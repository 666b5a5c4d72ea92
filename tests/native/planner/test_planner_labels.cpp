// FREE and FULL against long-double separations inside the closed cell, sought by pattern search.
#include <gtest/gtest.h>

#include "planar_planner/native/labels/classify.hpp"
#include "planner_worlds.hpp"

namespace {

using planner::ConstraintList;
using planner::Extent;
using planner::Label;
using planner::view;
using worlds::Random;
using worlds::Real;
using worlds::World;

struct Judged {
  Label label;
  planner::Witness witness;
  ConstraintList rest;
  double clearance;
};

Judged judge(World& world, const Extent& extent, const planner::ConstraintView& parent) {
  Judged out;
  planner::LabelResult result =
      world.labeller.label(planner::motion_of(world.space, extent),
                           world.posed_at(planner::rotation_of(world.space, extent)), parent);
  out.label = result.label;
  out.rest = std::move(result.undecided);
  out.witness = result.witness;
  out.clearance = result.clearance;
  return out;
}

void expect_true(Random& random, const World& world, const Extent& extent, const Label label,
                 const int starts) {
  const worlds::Box box = worlds::box_of(world.space, extent);
  if (label == Label::kFree) {
    const Real least = worlds::least_in(
        random, box, starts, [&](const worlds::Point& q) { return world.oracle.separation(q); });
    ASSERT_GT(least, 0.0L) << "FALSE FREE";
  } else if (label == Label::kFull) {
    const Real most = -worlds::least_in(
        random, box, starts, [&](const worlds::Point& q) { return -world.oracle.separation(q); });
    ASSERT_LT(most, 0.0L) << "FALSE FULL";
  }
}

TEST(PlannerLabels, HoldInTheWholeClosedSet) {
  std::array<int, 4> count{};
  const std::vector<worlds::Recipe> recipes = worlds::recipes();
  for (std::uint64_t seed = 0; seed < 45; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    worlds::Recipe recipe = recipes[seed % recipes.size()];
    recipe.rotation = seed % 7 != 6;
    World world(worlds::random_scene(random, recipe), 1.25);
    ConstraintList root;
    world.labeller.root_list(root);
    for (int i = 0; i < 60; ++i) {
      const Extent extent =
          worlds::random_extent(random, recipe.rotation, i % 3 == 0, i % 2 == 0 ? 5 : 9);
      const Judged judged = judge(world, extent, view(root));
      ++count[static_cast<std::size_t>(judged.label)];
      ASSERT_NO_FATAL_FAILURE(expect_true(random, world, extent, judged.label, 2));
    }
  }
  EXPECT_GT(count[static_cast<std::size_t>(Label::kFree)], 250);
  EXPECT_GT(count[static_cast<std::size_t>(Label::kFull)], 250);
  EXPECT_GT(count[static_cast<std::size_t>(Label::kMixed)], 250);
}

// Down a chain of halvings from a root: what the parents dropped stays dropped, truly.
TEST(PlannerLabels, InheritedListsGiveTrueLabels) {
  std::array<int, 4> count{};
  int differ = 0;
  const std::vector<worlds::Recipe> recipes = worlds::recipes();
  for (std::uint64_t seed = 0; seed < 180; ++seed) {
    SCOPED_TRACE(seed);
    Random random(5000 + seed);
    World world(worlds::random_scene(random, recipes[seed % recipes.size()]));
    planner::CellBox box;
    box.level[2] = 2;
    box.low[2] = static_cast<std::uint64_t>(worlds::pick(random, 0, 3)) * box.size(2);
    ConstraintList root;
    world.labeller.root_list(root);
    ConstraintList parent = root;
    for (int depth = 0; depth < 36; ++depth) {
      const Extent extent = planner::extent_of(box);
      Judged judged = judge(world, extent, view(parent));
      const Judged fresh = judge(world, extent, view(root));
      // Either may be the sharper one, but they never contradict each other.
      ASSERT_FALSE(judged.label == Label::kFree && fresh.label == Label::kFull);
      ASSERT_FALSE(judged.label == Label::kFull && fresh.label == Label::kFree);
      differ += judged.label != fresh.label;
      ++count[static_cast<std::size_t>(judged.label)];
      if (judged.label != Label::kMixed) {
        ASSERT_NO_FATAL_FAILURE(expect_true(random, world, extent, judged.label, 6));
        break;
      }
      parent = std::move(judged.rest);
      // Towards a contact: the half whose best or worst sample is nearer to touching.
      const planner::Halves halves =
          planner::halve(box, static_cast<std::size_t>(worlds::pick(random, 0, 2)));
      box = worlds::pick(random, 0, 1) == 0 ? halves.lower : halves.upper;
      const auto touching = [&](const planner::CellBox& half) {
        return std::abs(world.oracle.separation(
            worlds::box_of(world.space, planner::extent_of(half)).at(0.5L, 0.5L, 0.5L)));
      };
      if (worlds::pick(random, 0, 2) != 0)
        box = touching(halves.lower) < touching(halves.upper) ? halves.lower : halves.upper;
    }
  }
  EXPECT_GT(count[static_cast<std::size_t>(Label::kFree)], 20);
  EXPECT_GT(count[static_cast<std::size_t>(Label::kFull)], 20);
  EXPECT_LT(differ, 200);
}

// Cells of a subdivision refined towards contact, joint obstruction included.
TEST(PlannerLabels, CellsOfASubdivisionAreTrue) {
  int joint = 0;
  int checked = 0;
  const std::vector<worlds::Recipe> recipes = worlds::recipes();
  for (std::uint64_t seed = 0; seed < 9; ++seed) {
    SCOPED_TRACE(seed);
    Random random(9000 + seed);
    worlds::Recipe recipe = recipes[seed % recipes.size()];
    recipe.obstacles += 8;  // crowded: passages between pairs of obstacles
    recipe.rotation = seed % 5 != 4;
    World world(worlds::random_scene(random, recipe), -2.0);
    planner::Subdivision subdivision(world.space, world.labeller, world.statistics);
    for (int round = 0; round < 300; ++round) {
      std::vector<planner::CellId> mixed;
      for (planner::CellId id = 0; id < subdivision.size(); ++id)
        if (subdivision.cell(id).label == Label::kMixed) mixed.push_back(id);
      if (mixed.empty()) break;
      const auto latest = static_cast<int>(mixed.size()) - 1;
      subdivision.split(mixed[static_cast<std::size_t>(
          worlds::pick(random, 0, 1) == 0 ? latest : worlds::pick(random, 0, latest))]);
    }
    for (planner::CellId id = 0; id < subdivision.size(); ++id) {
      const planner::Cell& cell = subdivision.cell(id);
      if (cell.label == Label::kMixed || cell.label == Label::kStar) continue;
      joint += cell.joint;
      if (!cell.joint && worlds::pick(random, 0, 5) != 0) continue;
      ++checked;
      ASSERT_NO_FATAL_FAILURE(
          expect_true(random, world, planner::extent_of(cell.box), cell.label, cell.joint ? 6 : 2));
    }
  }
  EXPECT_GT(checked, 150);
  EXPECT_GT(joint, 20);
}

}  // namespace
