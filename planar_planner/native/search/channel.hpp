// The cheapest channel of solid and MIXED cells from start to goal (docs/method.md, "Search"), kept
// up to date while cells are split.
//
// Two trees grow towards each other, from start and from goal, each about half the channel's cost
// deep. A bottleneck lies where they meet, so refining it disturbs little of either.
#pragma once

#include <cstdint>
#include <vector>

#include "distance_tree.hpp"
#include "planar_planner/native/cells/growth.hpp"
#include "planar_planner/native/cells/subdivision.hpp"
#include "planar_planner/native/statistics.hpp"

namespace planner {

// What crossing a leaf costs a channel: a guess of the work that it takes to resolve it.
double crossing_cost(const CellFacts& cell);

class ChannelSearch {
 public:
  ChannelSearch(const Subdivision& subdivision, Statistics& statistics)
      : subdivision_(subdivision),
        from_start_(subdivision, doubtful_, statistics),
        from_goal_(subdivision, doubtful_, statistics) {}
  ChannelSearch(const ChannelSearch&) = delete;  // the trees refer to doubtful_
  ChannelSearch& operator=(const ChannelSearch&) = delete;

  // Starts anew between two leaves.
  void reset(CellId start, CellId goal);
  // To any of a set of goals, kept by the caller.
  void reset(CellId start, const Roots& goals);
  // Builds both trees from scratch on the present graph.
  void rebuild();

  // A leaf is about to be split, and has been: its lower half keeps its id; `start` and `goal` are
  // the leaves that hold the ends afterwards. A set of goals has been brought up to date.
  void before_split(CellId cell);
  void after_split(CellId lower, CellId upper, CellId start, CellId goal);
  // Other changes of the graph, after they happened.
  void on_exhausted(CellId cell);
  void on_disconnected(CellId a, CellId b);
  void on_doubtful(CellId a, CellId b);
  void on_goal_lost(CellId cell) { from_goal_.on_root_lost(cell); }

  // False: start and goal are not connected.
  bool find(std::vector<CellId>& channel);

  // Does the channel use an exhausted cell or a doubtful link? Then so does every other channel.
  [[nodiscard]] bool passes_barrier(const std::vector<CellId>& channel) const;

  [[nodiscard]] CellId start() const { return from_start_.root(); }
  // kNoCell for a set of goals.
  [[nodiscard]] CellId goal() const { return from_goal_.root(); }
  [[nodiscard]] std::size_t bytes() const;

 private:
  // A leaf that both trees have reached, and the cost of the channel through it.
  struct Meeting {
    float cost;
    CellId cell;
    bool operator<(const Meeting& other) const {
      return cost > other.cost || (cost == other.cost && cell > other.cell);
    }
  };

  [[nodiscard]] float cost_through(CellId cell) const;
  void note_meetings();
  // Cheapest meeting that still holds; its cost is kUnreached if there is none.
  Meeting best_meeting();

  const Subdivision& subdivision_;
  DoubtfulLinks doubtful_;
  DistanceTree from_start_;
  DistanceTree from_goal_;
  LazyQueue<Meeting> meetings_;
};

}  // namespace planner
