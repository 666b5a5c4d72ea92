// The subdivision of the (x, y, theta) domain: a kd-tree of dyadic cells with labels, what each
// leaf leaves undecided, and neighbour lists of the leaves that are not FULL. It outlives a query.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "cell.hpp"
#include "constraints.hpp"
#include "joint.hpp"
#include "label.hpp"
#include "star.hpp"
#include "statistics.hpp"

namespace planner {

using CellId = std::uint32_t;
inline constexpr CellId kNoCell = UINT32_MAX;

// One key for the unordered pair.
constexpr std::uint64_t link_key(const CellId a, const CellId b) {
  return (std::uint64_t{a < b ? a : b} << 32) | (a < b ? b : a);
}

struct Cell {
  CellBox box;
  Label label = Label::kMixed;
  bool exhausted = false;         // MIXED or doubtful at the resolution limit: never split again
  CellId children = 0;            // first of two; 0 for a leaf
  float separation = 0.0F;        // hint of the labelling, over the motion radius
  float size = 0.0F;              // motion radius over the robot's reach
  float cost = 0.0F;              // of crossing it (channel.hpp)
  float turning_radius = 0.0F;    // of the robot pieces still active
  std::uint32_t guard = 0;        // kStar: index of the guard
  ConstraintStore::Handle list;   // kMixed, kStar
  Witness witness;                // kFull by one pair
  bool joint = false;             // kFull by several pairs together (joint.hpp)
  std::vector<CellId> neighbours; // leaves that are not FULL, sharing a face of positive area

  [[nodiscard]] bool leaf() const { return children == 0; }
  [[nodiscard]] bool solid() const { return label == Label::kFree || label == Label::kStar; }
};

// What crossing a leaf that is not FULL costs a channel: a guess of the work it takes to resolve it.
double crossing_cost(const Cell& cell);

class Subdivision {
 public:
  // All references must outlive the subdivision.
  Subdivision(const CellSpace& space, Labeller& labeller, Statistics& statistics);

  [[nodiscard]] const CellSpace& space() const { return space_; }
  [[nodiscard]] std::size_t size() const { return cells_.size(); }
  [[nodiscard]] std::size_t leaves() const { return cells_.size() - inner_; }
  [[nodiscard]] const Cell& cell(CellId id) const { return cells_[id]; }
  [[nodiscard]] Vec2 guard(CellId id) const { return guards_[cells_[id].guard]; }
  [[nodiscard]] std::uint64_t guard_turns(CellId id) const;
  [[nodiscard]] ConstraintView undecided(CellId id) const { return store_.get(cells_[id].list); }
  [[nodiscard]] std::size_t bytes() const;

  // The leaf whose closed box holds the point (the lower one on a common face).
  [[nodiscard]] CellId locate(const std::array<std::uint64_t, 3>& point) const;

  // Can the cell still be halved above `resolution` (smallest motion radius, planner units)?
  [[nodiscard]] bool divisible(CellId id, double resolution) const;
  // Halves a leaf along the axis that moves the robot most, labels the halves, mends the
  // neighbour lists. Returns the first of the two consecutive children.
  CellId split(CellId id);
  void mark_exhausted(CellId id) { cells_[id].exhausted = true; }
  void disconnect(CellId a, CellId b);

 private:
  CellId add_cell(const CellBox& box, const ConstraintView& parent);
  void adopt_neighbours(CellId parent, CellId first_child);
  [[nodiscard]] int widest_axis(const Cell& cell) const;

  CellSpace space_;
  Labeller& labeller_;
  Statistics& statistics_;
  StarTest star_;
  JointTest joint_;
  std::vector<Cell> cells_;
  std::vector<Vec2> guards_;
  ConstraintStore store_;
  ConstraintList parent_list_, child_list_;
  std::size_t inner_ = 0;
  std::size_t neighbour_bytes_ = 0;
};

}  // namespace planner
