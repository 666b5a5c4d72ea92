// The cheapest channel of solid and MIXED cells from start to goal, kept up to date while cells are
// split (design: "Search: refine only what a channel needs").
//
// A shortest-path tree is mended, not rebuilt: a leaf that loses its predecessor looks for another
// one that is no farther, and only if there is none does its branch get new distances. Distances
// may be off by the factor 1 +- kSlack per step, which saves most of the mending; reachability is
// exact: if the graph holds a channel, one is found, and if none is found there is none.
#pragma once

#include <cstdint>
#include <limits>
#include <queue>
#include <unordered_map>
#include <vector>

#include "face.hpp"
#include "statistics.hpp"
#include "subdivision.hpp"

namespace planner {

class ChannelSearch {
 public:
  ChannelSearch(const Subdivision& subdivision, Statistics& statistics)
      : subdivision_(subdivision), statistics_(statistics) {}

  // Starts anew between two leaves.
  void reset(CellId start, CellId goal);

  // A leaf is about to be split, and has been: `start` and `goal` are the leaves that hold the ends
  // afterwards.
  void before_split(CellId cell);
  void after_split(CellId cell, CellId start, CellId goal);
  // Other changes of the graph, told after they happened.
  void on_exhausted(CellId cell);
  void on_disconnected(CellId a, CellId b);
  void on_doubtful(CellId a, CellId b);

  // False: start and goal are not connected.
  bool find(std::vector<CellId>& channel);

  // Does the channel use an exhausted cell or a doubtful link? Then so does every other channel.
  [[nodiscard]] bool passes_barrier(const std::vector<CellId>& channel) const;

  [[nodiscard]] CellId start() const { return start_; }
  [[nodiscard]] CellId goal() const { return goal_; }
  [[nodiscard]] std::size_t bytes() const;

 private:
  struct Node {
    double distance = std::numeric_limits<double>::infinity();
    double queued = std::numeric_limits<double>::infinity();  // least valid key in open_
    double cost = 0.0;                                        // of stepping into the cell
    CellId predecessor = kNoCell;
    bool live = false;  // a leaf that is not FULL
  };
  struct Step {
    double key;
    CellId cell;
    CellId from;
    bool operator<(const Step& other) const {  // std::priority_queue: cheapest first
      return key > other.key || (key == other.key && cell > other.cell);
    }
  };

  [[nodiscard]] double step_cost(CellId from, CellId to) const;
  void orphan(CellId cell);
  void orphan_successors(CellId cell);
  void mend();
  bool adopt(CellId cell, double old_distance);
  void add_nodes();
  [[nodiscard]] Step cheapest_step(CellId cell) const;
  void offer(CellId cell);
  void settle(const Step& step);

  const Subdivision& subdivision_;
  Statistics& statistics_;
  CellId start_ = kNoCell;
  CellId goal_ = kNoCell;
  std::vector<Node> nodes_;
  std::priority_queue<Step> open_;
  std::priority_queue<Step> orphans_;  // key: distance before the loss
  std::vector<CellId> raised_;
  bool parent_reached_ = false;
  std::unordered_map<std::uint64_t, bool> doubtful_;
};

}  // namespace planner
