// A shortest-path tree over the leaves that are not FULL, from one root or a set of them, mended
// while cells are split instead of being built anew.
//
// A leaf that loses its predecessor looks for another one that is no farther, and only if there is
// none does its branch get new distances. Distances may be off by a stated part of each step's
// cost, which saves most of the mending; what is reachable is exact. The tree is grown only as far
// as its caller asks.
//
// Invariant: every reached leaf but a root has a live, reached predecessor among its neighbours
// that is strictly nearer, so that predecessors lead to a root.
#pragma once

#include <cstdint>
#include <limits>
#include <unordered_set>
#include <vector>

#include "planar_planner/native/cells/growth.hpp"
#include "planar_planner/native/cells/subdivision.hpp"
#include "planar_planner/native/statistics.hpp"

namespace planner {

// Costs guide the search and prove nothing: single precision is enough.
inline constexpr float kUnreached = std::numeric_limits<float>::infinity();

// More than any channel without exhausted cells and doubtful links can cost.
inline constexpr float kBarrier = 1e15F;

// Links that could not be decided; passing one costs more than any channel without.
using DoubtfulLinks = std::unordered_set<std::uint64_t>;

// Leaves that a tree grows from, by id.
using Roots = std::vector<bool>;

class DistanceTree {
 public:
  DistanceTree(const Subdivision& subdivision, const DoubtfulLinks& doubtful,
               Statistics& statistics)
      : subdivision_(subdivision), doubtful_(doubtful), statistics_(statistics) {}

  void reset(CellId root);
  // From a set of roots, kept by the caller; entering one costs what the leaf costs.
  void reset(const Roots& roots);
  // From the same root or roots again.
  void rebuild();

  // A leaf is about to be split, and has been: its lower half keeps its id, `upper` is new; `root`
  // is the root's leaf afterwards, if there is one root; a set of roots has been brought up to
  // date.
  void before_split(CellId cell);
  void after_split(CellId lower, CellId upper, CellId root);
  // Other changes of the graph, after they happened.
  void on_exhausted(CellId cell);
  void on_link_lost(CellId a, CellId b);
  void on_root_lost(CellId cell);

  // After changes of the graph, before anything is asked. Reaches the root, if there is one.
  void begin_round();
  // Key of the next leaf to be settled, or kUnreached. What is nearer than it has been mended.
  float next_key();
  void settle_next();

  // Mends all that the leaf's distance may depend on. False if the leaf is unreached then.
  bool mend_way_to(CellId cell);
  [[nodiscard]] bool reached(CellId cell) const { return nodes_[cell].distance < kUnreached; }
  [[nodiscard]] float distance(CellId cell) const { return nodes_[cell].distance; }
  [[nodiscard]] float cost(CellId cell) const { return nodes_[cell].cost; }
  // kNoCell at a root.
  [[nodiscard]] CellId predecessor(CellId cell) const { return nodes_[cell].predecessor; }
  // kNoCell for a set of roots.
  [[nodiscard]] CellId root() const { return root_; }
  [[nodiscard]] std::size_t bytes() const;

  // Leaves whose distance was set or lowered since the caller last cleared the list.
  std::vector<CellId>& changed() { return changed_; }

 private:
  struct Node {
    float distance = kUnreached;  // including the cell's own cost
    float queued = kUnreached;    // least valid key in open_
    float cost = 0.0F;            // of stepping into the cell; negative: FULL
    CellId predecessor = kNoCell;
  };
  struct Step {
    float key;
    CellId cell;
    CellId from;
    bool operator<(const Step& other) const {  // LazyQueue: cheapest first
      return key > other.key || (key == other.key && cell > other.cell);
    }
  };

  [[nodiscard]] bool is_root(const CellId cell) const {
    return roots_ == nullptr ? cell == root_ : (*roots_)[cell];
  }
  void refresh(CellId cell);
  [[nodiscard]] float step_cost(CellId from, CellId to) const;
  void orphan(CellId cell);
  void orphan_successors(CellId cell);
  bool adopt(CellId cell, float old_distance);
  [[nodiscard]] Step cheapest_step(CellId cell) const;
  [[nodiscard]] bool holds(const Step& step) const;
  void offer(CellId cell);
  void tell(CellId next, CellId by);
  void mend_next();
  void settle(const Step& step);
  bool settle_root(CellId cell);
  void place(CellId cell, float distance, CellId predecessor);

  const Subdivision& subdivision_;
  const DoubtfulLinks& doubtful_;
  Statistics& statistics_;
  CellId root_ = kNoCell;
  const Roots* roots_ = nullptr;  // instead of root_
  std::vector<Node> nodes_;
  LazyQueue<Step> open_;
  LazyQueue<Step> orphans_;  // key: distance before the loss
  std::vector<CellId> raised_;
  std::vector<CellId> changed_;
  bool parent_reached_ = false;
};

}  // namespace planner
