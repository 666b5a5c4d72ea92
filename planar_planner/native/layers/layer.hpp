// The free translations at one orientation, exactly: a closed rectangle without the open sums of
// all pairs of pieces. What touches is free.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "open_sum.hpp"
#include "pdg/native/geometry/box_tree.hpp"
#include "planar_planner/native/world/scaled_problem.hpp"

namespace planner {

// Closed; empty where low > high.
struct LatticeRectangle {
  LatticePoint low, high;
};

constexpr bool contains(const LatticeRectangle& r, const LatticePoint p) {
  return r.low.x <= p.x && p.x <= r.high.x && r.low.y <= p.y && p.y <= r.high.y;
}

// A piece by its polygon and its place in the polygon's partition.
struct LayerPiece {
  std::uint32_t polygon = 0;
  std::uint32_t index = 0;
  LatticePolygon vertices;  // of the robot: turned as the layer is, about the reference point
};

struct Layer {
  Lattice lattice;
  LatticeRectangle domain;  // of the reference point
  std::vector<LayerPiece> robot, obstacles;
  std::vector<OpenSum> sums;
  pdg::BoxTree tree;  // of the sums' boxes, rounded outwards
  LatticePoint start, goal;
  std::vector<LatticePolygon> region;  // convex pieces of a goal region; none: `goal` is the goal
};

// Quarter turns of the robot: theta = quarters * pi / 2.
struct LayerQuery {
  int quarters = 0;
  Vec2 start, goal;     // the reference point, user's units
  double finest = 0.0;  // a length that the lattice has to hold besides; user's units
  // Obstacles that do not come near it are left out; user's units.
  std::optional<Rectangle> near = std::nullopt;
  const PolygonSet* region = nullptr;  // world frame; null: the goal is a point
};

// Limits on the size of a layer, by count.
struct LayerLimits {
  std::size_t sums;
  std::size_t vertices;
};

// Empty if the scene's numbers share no lattice (kLatticeBits) or the layer exceeds the limits.
std::optional<Layer> make_layer(const ScaledProblem& problem, const LayerQuery& query,
                                const LayerLimits& limits);

// The sum that a point is deepest in, and the distance to its nearest side in the user's unit;
// empty if it is in none.
struct Overlap {
  std::size_t sum;
  double depth;
};
std::optional<Overlap> deepest_overlap(const Layer& layer, LatticePoint p);

// Is the point in the closed goal region?
bool in_region(const Layer& layer, LatticePoint p);

// Sums whose boxes come near the rectangle spanned by a and b, in the order of the tree.
void find_near(const Layer& layer, LatticePoint a, LatticePoint b,
               std::vector<std::int32_t>& found);

// Not in any open sum and inside the domain. `scratch` is working space.
bool is_free(const Layer& layer, LatticePoint p, std::vector<std::int32_t>& scratch);
// The same for all points of the closed segment; its ends lie inside the domain.
bool is_free(const Layer& layer, LatticePoint a, LatticePoint b,
             std::vector<std::int32_t>& scratch);

}  // namespace planner
