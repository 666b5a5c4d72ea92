// The incremental search against searches from scratch on the same graph, and the neighbour lists
// against all pairs of leaves, while cells are split, exhausted and disconnected at random.
#include <gtest/gtest.h>

#include <queue>
#include <set>

#include "planar_planner/native/search/channel.hpp"
#include "planner_worlds.hpp"

namespace {

using planner::CellId;
using planner::DistanceTree;
using planner::DoubtfulLinks;
using planner::kBarrier;
using planner::kNoCell;
using planner::kUnreached;
using planner::Label;
using planner::Subdivision;
using worlds::Random;
using worlds::World;

std::vector<CellId> open_leaves(const Subdivision& subdivision) {
  std::vector<CellId> out;
  for (CellId id = 0; id < subdivision.size(); ++id)
    if (subdivision.cell(id).label != Label::kFull) out.push_back(id);
  return out;
}

double step_cost(const Subdivision& subdivision, const DoubtfulLinks& doubtful, const CellId from,
                 const CellId to) {
  const double cost = subdivision.cell(to).exhausted ? kBarrier : subdivision.cell(to).cost;
  return cost + (doubtful.contains(planner::link_key(from, to)) ? kBarrier : 0.0);
}

// Dijkstra from scratch.
std::vector<double> distances(const Subdivision& subdivision, const DoubtfulLinks& doubtful,
                              const CellId root) {
  std::vector<double> out(subdivision.size(), kUnreached);
  using Entry = std::pair<double, CellId>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  out[root] = 0.0;
  queue.push({0.0, root});
  while (!queue.empty()) {
    const auto [key, id] = queue.top();
    queue.pop();
    if (key > out[id]) continue;
    for (const CellId next : subdivision.cell(id).neighbours) {
      const double there = key + step_cost(subdivision, doubtful, id, next);
      if (there >= out[next]) continue;
      out[next] = there;
      queue.push({there, next});
    }
  }
  return out;
}

std::array<std::uint64_t, 3> random_point(Random& random) {
  std::array<std::uint64_t, 3> point{};
  for (std::uint64_t& x : point)
    x = std::uniform_int_distribution<std::uint64_t>(0, planner::kUnit - 1)(random);
  return point;
}

// A random change of the graph, as the planner makes them, told to `search`.
class Changes {
 public:
  Changes(Random& random, Subdivision& subdivision, DoubtfulLinks& doubtful)
      : random_(random), subdivision_(subdivision), doubtful_(doubtful) {}

  template <class Split, class Exhausted, class Lost, class Doubtful>
  void one(const Split& split, const Exhausted& exhausted, const Lost& lost,
           const Doubtful& doubted) {
    const std::vector<CellId> leaves = open_leaves(subdivision_);
    if (leaves.empty()) return;
    const CellId id = leaves[static_cast<std::size_t>(
        worlds::pick(random_, 0, static_cast<int>(leaves.size()) - 1))];
    const auto& neighbours = subdivision_.cell(id).neighbours;
    const int kind = worlds::pick(random_, 0, 19);
    if (kind < 14 || neighbours.empty()) {
      if (!subdivision_.divisible(id, 1e-3)) return;
      for (const CellId next : neighbours) doubtful_.erase(planner::link_key(id, next));
      split(id);
      return;
    }
    const CellId other = neighbours[static_cast<std::size_t>(
        worlds::pick(random_, 0, static_cast<int>(neighbours.size()) - 1))];
    if (kind < 15) {
      subdivision_.mark_exhausted(id);
      exhausted(id);
    } else if (kind < 19) {
      subdivision_.disconnect(id, other);
      lost(id, other);
    } else {
      doubtful_.insert(planner::link_key(id, other));
      doubted(id, other);
    }
  }

 private:
  Random& random_;
  Subdivision& subdivision_;
  DoubtfulLinks& doubtful_;
};

// Predecessors are reached, no farther, and linked, all the way to the root.
void expect_way_holds(const Subdivision& subdivision, const DistanceTree& tree, const CellId leaf) {
  CellId id = leaf;
  for (std::size_t steps = 0; id != tree.root(); ++steps) {
    ASSERT_LT(steps, subdivision.size()) << "predecessors in a circle";
    const CellId from = tree.predecessor(id);
    ASSERT_NE(from, kNoCell);
    ASSERT_TRUE(tree.reached(from));
    ASSERT_LE(tree.distance(from), tree.distance(id));
    const auto& near = subdivision.cell(id).neighbours;
    ASSERT_NE(std::find(near.begin(), near.end(), from), near.end())
        << "predecessor " << from << " of " << id << " is no neighbour";
    id = from;
  }
}

TEST(PlannerSearch, TreeReachesWhatASearchFromScratchReaches) {
  std::size_t cut_off = 0;
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    const std::vector<worlds::Recipe> recipes = worlds::recipes();
    World world(worlds::random_scene(random, recipes[seed % recipes.size()]));
    Subdivision subdivision(world.space, world.labeller, world.statistics, planner::crossing_cost);
    DoubtfulLinks doubtful;
    DistanceTree tree(subdivision, doubtful, world.statistics);
    const auto home = random_point(random);
    tree.reset(subdivision.locate(home));
    Changes changes(random, subdivision, doubtful);
    for (int round = 0; round < 60; ++round) {
      const int batch = worlds::pick(random, 1, 6);
      for (int i = 0; i < batch; ++i)
        changes.one(
            [&](const CellId id) {
              tree.before_split(id);
              const CellId upper = subdivision.split(id);
              tree.after_split(id, upper,
                               tree.root() == id ? subdivision.locate(home) : tree.root());
            },
            [&](const CellId id) { tree.on_exhausted(id); },
            [&](const CellId a, const CellId b) { tree.on_link_lost(a, b); },
            [&](const CellId a, const CellId b) { tree.on_link_lost(a, b); });
      tree.begin_round();
      tree.changed().clear();
      int steps = worlds::pick(random, 0, 3) == 0 ? 5 : INT32_MAX;  // sometimes half-grown
      const bool whole = steps > 5;
      while (steps-- > 0 && tree.next_key() < kUnreached) tree.settle_next();
      if (!whole) {  // only what is asked for is mended: here one leaf's way to the root
        const CellId asked =
            static_cast<CellId>(worlds::pick(random, 0, static_cast<int>(subdivision.size()) - 1));
        if (tree.mend_way_to(asked)) {
          ASSERT_NO_FATAL_FAILURE(expect_way_holds(subdivision, tree, asked)) << "round " << round;
        }
        continue;
      }
      for (const CellId id : open_leaves(subdivision)) {
        if (!tree.reached(id)) continue;
        ASSERT_NO_FATAL_FAILURE(expect_way_holds(subdivision, tree, id)) << "round " << round;
      }
      const std::vector<double> exact = distances(subdivision, doubtful, tree.root());
      for (const CellId id : open_leaves(subdivision)) {
        ASSERT_EQ(tree.reached(id), exact[id] < kUnreached) << "round " << round << " cell " << id;
        cut_off += exact[id] < kUnreached ? 0 : 1;
        if (tree.reached(id)) {
          ASSERT_GE(tree.distance(id), 0.09 * exact[id]) << "round " << round << " cell " << id;
        }
      }
    }
  }
  EXPECT_GT(cut_off, 1000U);  // the changes did cut leaves off
}

TEST(PlannerSearch, ChannelExistsExactlyWhenTheGraphIsConnected) {
  std::size_t found = 0;
  std::size_t none = 0;
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    SCOPED_TRACE(seed);
    Random random(1000 + seed);
    const std::vector<worlds::Recipe> recipes = worlds::recipes();
    World world(worlds::random_scene(random, recipes[seed % recipes.size()]));
    Subdivision subdivision(world.space, world.labeller, world.statistics, planner::crossing_cost);
    planner::ChannelSearch search(subdivision, world.statistics);
    DoubtfulLinks doubtful;
    const auto start = random_point(random);
    const auto goal = random_point(random);
    search.reset(subdivision.locate(start), subdivision.locate(goal));
    Changes changes(random, subdivision, doubtful);
    std::vector<CellId> channel;
    for (int round = 0; round < 60; ++round) {
      const int batch = worlds::pick(random, 1, 6);
      for (int i = 0; i < batch; ++i)
        changes.one(
            [&](const CellId id) {
              search.before_split(id);
              const CellId upper = subdivision.split(id);
              search.after_split(id, upper,
                                 search.start() == id ? subdivision.locate(start) : search.start(),
                                 search.goal() == id ? subdivision.locate(goal) : search.goal());
            },
            [&](const CellId id) { search.on_exhausted(id); },
            [&](const CellId a, const CellId b) { search.on_disconnected(a, b); },
            [&](const CellId a, const CellId b) { search.on_doubtful(a, b); });
      const bool connected = search.find(channel);
      const std::vector<double> exact = distances(subdivision, doubtful, search.start());
      ASSERT_EQ(connected, exact[search.goal()] < kUnreached) << "round " << round;
      (connected ? found : none) += 1;
      if (!connected) continue;
      ASSERT_EQ(channel.front(), search.start());
      ASSERT_EQ(channel.back(), search.goal());
      for (std::size_t i = 0; i + 1 < channel.size(); ++i) {
        const auto& near = subdivision.cell(channel[i]).neighbours;
        ASSERT_NE(std::find(near.begin(), near.end(), channel[i + 1]), near.end())
            << "round " << round << ": a link that is gone";
      }
      // A channel over a barrier means that there is none without.
      const double ends = subdivision.cell(search.goal()).exhausted ? kBarrier : 0.0;
      if (search.passes_barrier(channel) && !subdivision.cell(search.start()).exhausted) {
        ASSERT_GE(exact[search.goal()] + ends, kBarrier) << "round " << round;
      }
    }
  }
  EXPECT_GT(found, 500U);
  EXPECT_GT(none, 100U);
}

TEST(PlannerSearch, NeighbourListsAreThePairsOfTouchingLeaves) {
  for (std::uint64_t seed = 0; seed < 18; ++seed) {
    SCOPED_TRACE(seed);
    Random random(2000 + seed);
    std::vector<worlds::Recipe> recipes = worlds::recipes();
    worlds::Recipe recipe = recipes[seed % recipes.size()];
    recipe.rotation = seed < 12;
    World world(worlds::random_scene(random, recipe), 0.3);
    Subdivision subdivision(world.space, world.labeller, world.statistics, planner::crossing_cost);
    for (int round = 0; round < 80; ++round) {
      const std::vector<CellId> leaves = open_leaves(subdivision);
      if (leaves.empty()) break;
      const CellId id = leaves[static_cast<std::size_t>(
          worlds::pick(random, 0, static_cast<int>(leaves.size()) - 1))];
      if (subdivision.divisible(id, 1e-3)) subdivision.split(id);
    }
    const std::vector<CellId> leaves = open_leaves(subdivision);
    for (const CellId a : leaves) {
      std::set<CellId> expected;
      const planner::CellBox& p = subdivision.cell(a).box;
      for (const CellId b : leaves) {
        if (a == b) continue;
        const planner::CellBox& q = subdivision.cell(b).box;
        int overlaps = 0;  // axes along which the interiors overlap
        int touches = 0;
        for (std::size_t k = 0; k < 3; ++k) {
          const auto p_end = p.low[k] + (planner::kUnit >> p.level[k]);
          const auto q_end = q.low[k] + (planner::kUnit >> q.level[k]);
          if (p.low[k] < q_end && q.low[k] < p_end)
            ++overlaps;
          else if (p_end == q.low[k] || q_end == p.low[k] ||
                   (k == 2 &&
                    (p_end % planner::kUnit == q.low[k] || q_end % planner::kUnit == p.low[k])))
            ++touches;
        }
        if (overlaps == 2 && touches == 1) expected.insert(b);
      }
      const auto& near = subdivision.cell(a).neighbours;
      const std::set<CellId> listed(near.begin(), near.end());
      ASSERT_EQ(listed.size(), near.size()) << "a neighbour twice";
      ASSERT_EQ(listed, expected) << "cell " << a;
    }
    // Every point lies in exactly the leaf that locate() gives.
    for (int i = 0; i < 200; ++i) {
      const auto point = random_point(random);
      const planner::CellBox& box = subdivision.cell(subdivision.locate(point)).box;
      for (std::size_t k = 0; k < 3; ++k) {
        ASSERT_LE(box.low[k], point[k]);
        ASSERT_GT(box.high(k), point[k]);
      }
    }
  }
}

}  // namespace
