// A body's convex pieces at a configuration, and the pairs of its pieces with another body's whose
// boxes overlap, deepest boxes first.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "pdg/native/geometry/box_tree.hpp"
#include "pdg/native/pieces/piece_set.hpp"

namespace pdg {

// Piece i owns [first[i], first[i + 1]). Kept between queries, its storage is used again.
struct PlacedBody {
  std::vector<Vec2> vertices;   // the doubles that placed() gives
  std::vector<Vec2> normals;    // outward unit normal of the edge that starts at the vertex
  std::vector<double> offsets;  // normal . vertex
  std::vector<Vec2> centres;    // per piece: of a bounding circle
  std::vector<std::uint32_t> first;
  std::vector<Box> boxes;  // per node of the body's tree, in its order
  double error = 0.0;      // of a separating-axis function against the other body: see place()
};

// `other_radius` bounds the other body's |vertex|. Fills `error` with the rounding error
// kSeparationErrorUnits u (A + B + T), between exact values and those of pair_separation.
void place(const PieceSet& body, const Pose& pose, double other_radius, PlacedBody& result);

// The same of the body's hull, as one piece without boxes.
void place_hull(const PieceSet& body, const Pose& pose, double other_radius, PlacedBody& result);

struct Separation {
  double value = 0.0;
  Vec2 normal;  // unit; moving A along it lessens an overlap
};

// Largest separating-axis function of piece i of `a` and a piece of the fixed body: minus PD^t
// where they overlap. Within a.error of the exact one. Stops at the first axis that reaches
// `enough`, and then gives that one.
Separation pair_separation(const PlacedBody& a, std::size_t i, const ConvexPiece& b, double enough);

// The shortest translation along an axis that takes two boxes apart: their contents' PD^t is at
// most that. Positive exactly when the boxes' interiors meet.
inline double box_depth(const Box& a, const Box& b) {
  return std::min(std::min(a.high.x - b.low.x, b.high.x - a.low.x),
                  std::min(a.high.y - b.low.y, b.high.y - a.low.y));
}

// Calls visit(i, j) for pairs of pieces down both trees, of two children the one with the deeper
// box first, as long as wanted(box_depth) holds.
template <class Wanted, class Visit>
class NearPairs {
 public:
  NearPairs(const BoxTree& a, const std::vector<Box>& a_boxes, const BoxTree& b, Wanted wanted,
            Visit visit)
      : a_(a.nodes), a_boxes_(a_boxes), b_(b.nodes), wanted_(wanted), visit_(visit) {}

  void run() {
    if (a_.empty() || b_.empty()) return;
    if (wanted_(depth(0, 0))) descend(0, 0);
  }

 private:
  [[nodiscard]] double depth(const std::uint32_t i, const std::uint32_t j) const {
    return box_depth(a_boxes_[i], b_[j].box);
  }

  void descend(const std::uint32_t i, const std::uint32_t j) {
    const bool leaf_a = a_[i].item >= 0;
    const bool leaf_b = b_[j].item >= 0;
    if (leaf_a && leaf_b) {
      visit_(static_cast<std::size_t>(a_[i].item), static_cast<std::size_t>(b_[j].item));
    } else if (leaf_b || (!leaf_a && half_perimeter(a_boxes_[i]) > half_perimeter(b_[j].box))) {
      both(i + 1, j, a_[i + 1].after, j);
    } else {
      both(i, j + 1, i, b_[j + 1].after);
    }
  }

  void both(const std::uint32_t i1, const std::uint32_t j1, const std::uint32_t i2,
            const std::uint32_t j2) {
    const double d1 = depth(i1, j1);
    const double d2 = depth(i2, j2);
    if (d1 >= d2) {
      if (wanted_(d1)) descend(i1, j1);
      if (wanted_(d2)) descend(i2, j2);
    } else {
      if (wanted_(d2)) descend(i2, j2);
      if (wanted_(d1)) descend(i1, j1);
    }
  }

  static double half_perimeter(const Box& box) {
    return (box.high.x - box.low.x) + (box.high.y - box.low.y);
  }

  std::span<const BoxTree::Node> a_;
  const std::vector<Box>& a_boxes_;
  std::span<const BoxTree::Node> b_;
  Wanted wanted_;
  Visit visit_;
};

}  // namespace pdg
