// What certificates are made of: least cuts against all cuts, adjacency against all pairs of
// leaves, barriers against flood fills, separating edges against points of the segment.
#include <gtest/gtest.h>

#include <set>

#include "planar_planner/native/cells/adjacency.hpp"
#include "planar_planner/native/evidence/barrier.hpp"
#include "planar_planner/native/evidence/minimum_cut.hpp"
#include "planar_planner/native/planning/planner.hpp"
#include "planner_worlds.hpp"

namespace {

using planner::Axis;
using planner::CellId;
using planner::Label;
using planner::MinimumCut;
using planner::Subdivision;
using worlds::Random;
using worlds::World;

TEST(PlannerBarrier, MinimumCutIsTheLeastOfAllCuts) {
  std::size_t positive = 0;
  for (std::uint64_t seed = 0; seed < 400; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    const auto nodes = static_cast<std::uint32_t>(worlds::pick(random, 2, 9));
    std::vector<std::array<std::uint32_t, 4>> arcs;
    MinimumCut cut(nodes);
    for (int i = worlds::pick(random, 1, 25); i > 0; --i) {
      const auto any = [&](const int high) {
        return static_cast<std::uint32_t>(worlds::pick(random, 0, high));
      };
      const auto u = any(static_cast<int>(nodes) - 1);
      const auto v = any(static_cast<int>(nodes) - 1);
      if (u == v) continue;
      arcs.push_back({u, v, any(4), any(4)});
      cut.add_arc(u, v, arcs.back()[2], arcs.back()[3]);
    }
    const auto capacity = [&](const auto& on_source_side) {
      std::uint64_t sum = 0;
      for (const auto& [u, v, forth, back] : arcs) {
        if (on_source_side(u) && !on_source_side(v)) sum += forth;
        if (on_source_side(v) && !on_source_side(u)) sum += back;
      }
      return sum;
    };
    std::uint64_t least = UINT64_MAX;  // source 0, sink 1
    for (std::uint32_t set = 0; set < (1U << nodes); ++set)
      if ((set & 3U) == 1U)
        least = std::min(least, capacity([&](const auto v) { return (set >> v & 1U) != 0; }));
    ASSERT_EQ(cut.solve(0, 1), least);
    ASSERT_EQ(capacity([&](const auto v) { return cut.on_source_side(v); }), least);
    positive += least > 0 ? 1 : 0;
  }
  EXPECT_GT(positive, 200U);
}

// Random leaves split at random.
void refine(Random& random, Subdivision& subdivision, const int rounds) {
  for (int round = 0; round < rounds; ++round) {
    const auto id =
        static_cast<CellId>(worlds::pick(random, 0, static_cast<int>(subdivision.size()) - 1));
    if (subdivision.divisible(id, 1e-3)) subdivision.split(id);
  }
}

using Pairs = std::set<std::pair<CellId, CellId>>;

Pairs adjacent_leaves(const Subdivision& s) {
  Pairs pairs;
  for (CellId a = 0; a < s.size(); ++a)
    for (CellId b = a + 1; b < s.size(); ++b) {
      Axis axis = planner::kNoAxis;
      const bool rotation_seam_only = !s.space().rotation;
      if (adjacent(s.cell(a).box, s.cell(b).box, axis) &&
          !(rotation_seam_only && axis == planner::kTheta))
        pairs.insert({a, b});
    }
  return pairs;
}

TEST(PlannerBarrier, AdjacencyIsThePairsOfTouchingLeaves) {
  for (std::uint64_t seed = 0; seed < 18; ++seed) {
    SCOPED_TRACE(seed);
    Random random(3000 + seed);
    worlds::Recipe recipe = worlds::recipes()[seed % worlds::recipes().size()];
    recipe.rotation = seed < 12;
    World world(worlds::random_scene(random, recipe), 0.3);
    Subdivision subdivision(world.space, world.labeller, world.statistics);
    refine(random, subdivision, 400);
    Pairs visited;
    visit_adjacent(subdivision, [&](const CellId a, const CellId b) {
      EXPECT_TRUE(visited.insert(std::minmax(a, b)).second) << "visited twice";
    });
    EXPECT_EQ(visited, adjacent_leaves(subdivision));
  }
}

bool inside(const planner::CellBox& leaf, const std::vector<planner::CellBox>& boxes) {
  for (const planner::CellBox& box : boxes) {
    bool holds = true;
    for (Axis k = 0; k < planner::kNoAxis; ++k)
      holds = holds && box.low[k] <= leaf.low[k] && leaf.high(k) <= box.high(k);
    if (holds) return true;
  }
  return false;
}

TEST(PlannerBarrier, SeparatesStartFromGoal) {
  std::size_t separated = 0;
  std::size_t open = 0;
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    SCOPED_TRACE(seed);
    Random random(4000 + seed);
    const worlds::Recipe recipe{.obstacles = 5, .robot_size = 1.6, .obstacle_size = 4.0};
    World world(worlds::random_scene(random, recipe));
    Subdivision s(world.space, world.labeller, world.statistics);
    refine(random, s, 3000);
    std::vector<CellId> leaves;
    for (CellId id = 0; id < s.size(); ++id)
      if (s.cell(id).label != Label::kFull) leaves.push_back(id);
    if (leaves.size() < 2) continue;
    const CellId start = leaves.front();
    CellId goal = leaves.back();
    for (const CellId id : leaves)
      if (s.connected(start, id) == (seed % 3 == 0)) goal = id;  // the last such leaf, if any
    if (start == goal) continue;
    const planner::Barrier barrier = find_barrier(s, {}, {&start, 1}, {&goal, 1});
    ASSERT_EQ(barrier.start_side.empty(), s.connected(start, goal));
    (barrier.start_side.empty() ? open : separated) += 1;
    if (barrier.start_side.empty()) continue;
    EXPECT_TRUE(inside(s.cell(start).box, barrier.start_side));
    EXPECT_FALSE(inside(s.cell(goal).box, barrier.start_side));
    std::set<std::array<std::uint64_t, 6>> cut;
    const auto key = [](const planner::Extent& e) {
      return std::array{e.low[0], e.low[1], e.low[2], e.size[0], e.size[1], e.size[2]};
    };
    for (const planner::FullClaim& claim : barrier.cells) cut.insert(key(claim.box));
    for (const auto& [a, b] : adjacent_leaves(s)) {
      const bool a_in = inside(s.cell(a).box, barrier.start_side);
      const bool b_in = inside(s.cell(b).box, barrier.start_side);
      if (a_in == b_in) continue;
      const CellId out = a_in ? b : a;
      ASSERT_TRUE(cut.contains(key(extent_of(s.cell(out).box)))) << "a face without a barrier";
    }
  }
  EXPECT_GT(separated, 10U);
  EXPECT_GT(open, 10U);
}

TEST(PlannerBarrier, LeavesNearAPointAreThoseWhoseBoxesComeNear) {
  std::size_t several = 0;
  for (std::uint64_t seed = 0; seed < 6; ++seed) {
    SCOPED_TRACE(seed);
    Random random(6000 + seed);
    World world(worlds::random_scene(random, worlds::recipes()[seed]));
    Subdivision s(world.space, world.labeller, world.statistics);
    refine(random, s, 300);
    for (int i = 0; i < 200; ++i) {
      const planner::CellBox& some =
          s.cell(static_cast<CellId>(worlds::pick(random, 0, static_cast<int>(s.size()) - 1))).box;
      std::array<std::uint64_t, 3> point{};  // at a corner of some leaf, or a little off it
      for (Axis k = 0; k < planner::kNoAxis; ++k) {
        const auto off = static_cast<std::uint64_t>(worlds::pick(random, 0, 6));
        const std::uint64_t corner = worlds::pick(random, 0, 1) == 0 ? some.low[k] : some.high(k);
        point[k] = std::min(corner + off, planner::kUnit - 1);
      }
      constexpr std::int64_t slack = 3;
      constexpr auto turn = static_cast<std::int64_t>(planner::kUnit);
      std::set<CellId> expected;
      for (CellId id = 0; id < s.size(); ++id) {
        bool near = true;
        for (Axis k = 0; k < planner::kNoAxis; ++k) {
          const planner::CellBox& box = s.cell(id).box;
          const auto within = [&](const std::int64_t p) {
            return static_cast<std::int64_t>(box.low[k]) - slack <= p &&
                   p <= static_cast<std::int64_t>(box.high(k)) + slack;
          };
          const auto p = static_cast<std::int64_t>(point[k]);
          near = near &&
                 (within(p) || (k == planner::kTheta && (within(p + turn) || within(p - turn))));
        }
        if (near) expected.insert(id);
      }
      const std::vector<CellId> found = s.leaves_near(point, slack);
      ASSERT_EQ(std::set<CellId>(found.begin(), found.end()), expected);
      several += found.size() > 1 ? 1 : 0;
    }
  }
  EXPECT_GT(several, 300U);
}

TEST(PlannerBarrier, EdgesSeparateTheirPairsAllAlongTheSegment) {
  std::size_t proven = 0;
  std::size_t edges = 0;
  for (std::uint64_t seed = 0; seed < 900; ++seed) {
    SCOPED_TRACE(seed);
    Random random(5000 + seed);
    const worlds::Recipe recipe = worlds::recipes()[seed % worlds::recipes().size()];
    World world(worlds::random_scene(random, recipe));
    const auto any = [&](const double size) { return worlds::uniform(random, -size, size); };
    const planner::ScaledConfiguration from{{any(0.6), any(0.6)}, any(4.0)};
    const planner::ScaledConfiguration to{{from.t.x + any(0.3), from.t.y + any(0.3)},
                                          from.theta + any(1.0)};
    planner::SegmentTest segments(world.problem, world.labeller, world.statistics);
    planner::SeparatingEdges separating(world.problem, world.tree, 1.0);
    const auto proof = separating.prove(from, to);
    if (segments.certify(from, to)) {
      ASSERT_TRUE(proof) << "certified, but without witnesses";
    }
    if (!proof) continue;
    ++proven;
    double at = 0.0;
    for (const planner::ProvenInterval& part : *proof) {
      ASSERT_EQ(part.interval.begin, at);
      at = part.interval.end;
      edges += part.edges.size();
      for (int i = 0; i <= 4; ++i) {
        const double s = part.interval.begin + 0.25 * i * (part.interval.end - part.interval.begin);
        const planner::ScaledConfiguration q = between(from, to, s);
        ASSERT_GE(world.oracle.separation({q.t.x, q.t.y, q.theta}), -1e-15L);
      }
    }
    ASSERT_EQ(at, 1.0);
  }
  EXPECT_GT(proven, 50U);
  EXPECT_GT(edges, 100U);
}

}  // namespace
