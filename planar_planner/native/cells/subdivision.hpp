// The subdivision of the (x, y, theta) domain: a kd-tree of dyadic cells with labels, what each
// leaf leaves undecided, and neighbour lists of the leaves that are not FULL. It outlives a query.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "planar_planner/native/configurations/dyadic_box.hpp"
#include "planar_planner/native/labels/classify.hpp"
#include "planar_planner/native/labels/constraints.hpp"
#include "planar_planner/native/labels/full_claim.hpp"
#include "planar_planner/native/labels/label.hpp"
#include "planar_planner/native/statistics.hpp"

namespace planner {

using CellId = std::uint32_t;
inline constexpr CellId kNoCell = UINT32_MAX;

// One key for the unordered pair.
constexpr std::uint64_t link_key(const CellId a, const CellId b) {
  return (std::uint64_t{a < b ? a : b} << 32U) | (a < b ? b : a);
}

// A leaf. Ids are stable until the leaf is split; its lower half then keeps the id.
struct Cell {
  CellBox box;
  Label label = Label::kMixed;
  std::uint8_t split_axis = kNoAxis;  // the axis to halve it along; kNoAxis: at the deepest level
  bool exhausted = false;             // at the resolution limit: never split again
  bool joint = false;        // kFull by several pairs together (joint.hpp), not by `witness`
  float split_width = 0.0F;  // half-width along split_axis as robot motion, planner units
  float size = 0.0F;         // motion radius over the robot's reach
  float cost = 0.0F;         // of crossing it, for a channel
  std::uint32_t guard = 0;   // kStar: index of the guard
  std::uint32_t branch = 0;  // whose half it is, times two, plus one if upper
  union {
    ConstraintStore::Handle list{};  // kMixed, kStar: what it leaves undecided
    Witness witness;                 // kFull, by one pair
    std::uint32_t proof;             // kFull, joint: index of the proof
  };
  std::vector<CellId> neighbours;  // leaves that are not FULL, sharing a face of positive area

  [[nodiscard]] bool solid() const { return label == Label::kFree || label == Label::kStar; }
};

// What the cost of crossing a leaf is made of.
struct CellFacts {
  Label label;
  double relative_size;  // motion radius over the robot's reach
  double separation;     // the labelling's hint over the motion radius
  double thinness;       // how often it was halved along single axes beyond its motion radius
};

// Whoever searches the cells says what crossing one costs (search/channel.hpp).
using CellCost = double (*)(const CellFacts&);
inline double no_cost(const CellFacts& /*cell*/) {
  return 0.0;
}

class Subdivision {
 public:
  // All references must outlive the subdivision.
  Subdivision(const CellSpace& space, Labeller& labeller, Statistics& statistics,
              CellCost cost = no_cost);

  [[nodiscard]] const CellSpace& space() const { return space_; }
  // Number of leaves; ids are 0 .. size() - 1.
  [[nodiscard]] std::size_t size() const { return cells_.size(); }
  [[nodiscard]] const Cell& cell(CellId id) const { return cells_[id]; }
  // Why a FULL leaf is FULL.
  [[nodiscard]] FullClaim claim(CellId id) const;
  [[nodiscard]] Vec2 guard(CellId id) const { return guards_[cells_[id].guard]; }
  [[nodiscard]] std::uint64_t guard_turns(CellId id) const;
  [[nodiscard]] ConstraintView undecided(CellId id) const { return store_.get(cells_[id].list); }
  [[nodiscard]] std::size_t bytes() const;
  // The part of it that holds what the leaves leave undecided.
  [[nodiscard]] std::size_t constraint_bytes() const { return store_.bytes(); }

  // The leaf whose closed box holds the point (the lower one on a common face).
  [[nodiscard]] CellId locate(const std::array<std::uint64_t, 3>& point) const;

  // All leaves, of any label, whose closed boxes come within `slack` of the point along every axis.
  [[nodiscard]] std::vector<CellId> leaves_near(const std::array<std::uint64_t, 3>& point,
                                                std::uint64_t slack) const;

  // Is the cell still wider than `resolution` along the axis that it would be halved along?
  [[nodiscard]] bool divisible(CellId id, double resolution) const;
  // Halves a leaf along the axis that moves the robot most, labels the halves, mends the
  // neighbour lists. The lower half keeps the id; the upper half's is returned.
  CellId split(CellId id);
  // The resolution limit belongs to a query: clear before the next one.
  void mark_exhausted(CellId id);
  void clear_exhausted();
  void disconnect(CellId a, CellId b);
  // Neighbours that have not been disconnected?
  [[nodiscard]] bool linked(CellId a, CellId b) const;
  // Is there any chain of neighbours from a to b? A plain flood fill that owes nothing to the
  // search.
  [[nodiscard]] bool connected(CellId a, CellId b) const { return connected({&a, 1}, {&b, 1}); }
  // From any of some leaves to any of others; FULL ones have no neighbours.
  [[nodiscard]] bool connected(std::span<const CellId> from, std::span<const CellId> to) const;

  // The kd-tree itself: a node is a leaf (kLeaf set, the rest its id) or the index of a branch.
  struct Branch {
    std::uint32_t lower, upper;
    Axis axis;
  };
  static constexpr std::uint32_t kLeaf = std::uint32_t{1} << 31U;
  // One for each equal part of the theta axis, in order; the box of part i.
  [[nodiscard]] const std::vector<std::uint32_t>& roots() const { return roots_; }
  [[nodiscard]] CellBox root_box(std::size_t part) const;
  [[nodiscard]] const Branch& branch(std::uint32_t node) const { return branches_[node]; }

 private:
  static constexpr std::uint32_t kRoot = std::uint32_t{1} << 31U;  // Cell::branch of a root

  [[nodiscard]] std::uint8_t root_level() const;
  void collect_near(std::uint32_t node, const CellBox& box,
                    const std::array<std::uint64_t, 3>& point, std::uint64_t slack,
                    std::vector<CellId>& out) const;

  void count(const Classification& found);
  void keep(Classification& found, Cell& cell);
  Cell make_cell(const CellBox& box, const ConstraintView& parent);
  void adopt_neighbours(CellId lower, CellId upper, const Halves& halves, Axis axis,
                        const std::vector<CellId>& old);
  void link(CellId a, CellId b);
  void add_neighbour(CellId to, CellId neighbour);
  // `widths`: how far the cell's halves along x, y and theta move the robot.
  [[nodiscard]] Axis best_axis(const CellBox& box, const pdg::Sway& sway,
                               const std::array<double, 3>& widths) const;

  CellSpace space_;
  Labeller& labeller_;
  Statistics& statistics_;
  CellCost cost_;
  PosedRobot posed_;
  Scratch scratch_;
  std::vector<Cell> cells_;
  std::vector<Branch> branches_;
  std::vector<std::uint32_t> roots_;  // leaves (kLeaf set) or branches
  std::vector<Vec2> guards_;
  std::vector<JointProof> proofs_;
  ConstraintStore store_;
  ConstraintList parent_list_;
  std::vector<CellId> below_, above_;
  std::size_t neighbour_bytes_ = 0;
  std::size_t proof_bytes_ = 0;
  bool any_exhausted_ = false;
};

}  // namespace planner
