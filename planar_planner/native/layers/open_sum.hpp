// One pair of convex pieces at a fixed orientation: the translations at which their interiors meet
// are the interior of the convex sum of the obstacle's piece and the mirrored robot piece. What
// only touches is free, so every set here is open.
#pragma once

#include <cstdint>
#include <vector>

#include "lattice.hpp"

namespace planner {

// Interior of a convex polygon of positive area.
struct OpenSum {
  std::vector<LatticePoint> vertices;  // counter-clockwise, no three in a row collinear
  LatticePoint low, high;              // bounding box
  std::uint32_t robot_piece = 0;       // of the layer's pieces
  std::uint32_t obstacle_piece = 0;
};

using LatticePolygon = std::vector<LatticePoint>;  // convex, counter-clockwise

// obstacle + (-robot); both strictly convex.
LatticePolygon convex_sum(const LatticePolygon& obstacle, const LatticePolygon& robot);
OpenSum make_open_sum(const LatticePolygon& obstacle, const LatticePolygon& robot);

bool contains(const OpenSum& sum, LatticePoint p);
// Does the closed segment from a to b meet the open sum?
bool meets_segment(const OpenSum& sum, LatticePoint a, LatticePoint b);
bool overlap(const OpenSum& a, const OpenSum& b);
// Has the open sum a common point with a closed convex polygon?
bool overlap(const OpenSum& sum, const LatticePolygon& polygon);
// Have the two open sets a common point whose abscissa exceeds x?
bool overlap_right_of(const OpenSum& a, const OpenSum& b, Int64 x);

// Where the vertical line through p meets the sum, if it does; p itself does not lie in the sum.
enum class Slice : std::uint8_t { kNone, kBelow, kAbove };
Slice slice_at(const OpenSum& sum, LatticePoint p);

}  // namespace planner
