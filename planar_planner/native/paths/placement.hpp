// Single configurations: free, in contact, colliding (with what, and how deep), or out of bounds;
// and the way out of a contact that the user tolerates.
#pragma once

#include <cstdint>
#include <optional>

#include "planar_planner/native/labels/label.hpp"
#include "planar_planner/native/world/obstacle_tree.hpp"
#include "planar_planner/native/world/problem.hpp"
#include "planar_planner/native/world/scaled_problem.hpp"
#include "segment.hpp"

namespace planner {

enum class PlacementState : std::uint8_t {
  kFree,       // every pair apart by more than the rounding error
  kContact,    // not distinguishable from touching by rounded arithmetic
  kColliding,  // some pair overlaps by more than the rounding error
  kOutside,    // the reference point is out of its bounds
};

struct Placement {
  PlacementState state = PlacementState::kFree;
  bool exact = false;          // kColliding: rounded arithmetic leaves it open
  bool wall = false;           // kColliding, kContact: the workspace, not an obstacle
  std::int64_t obstacle = -1;  // kColliding: polygon of the deepest pair; -1 for a wall
  std::uint32_t robot_polygon = 0;
  Witness witness{};       // kColliding: two pieces that overlap
  double depth = 0.0;      // kColliding: max over pairs of PD^t; kOutside: distance; user's units
  double clearance = 0.0;  // kFree: certified lower bound, user's units
};

// How far the reference point is out of its bounds, user's units; 0 inside.
double outside_bounds(const ScaledProblem& problem, const Configuration& q);

Placement place(const ScaledProblem& problem, ObstacleTree& tree, Labeller& labeller,
                const Configuration& q);

// A free configuration found by translating q by at most `tolerance` (user's units), off the
// contact by the shortest way and then on into the open: the meaning of the contact tolerance.
// Every configuration on the straight way there has PD^t <= tolerance. Deterministic; empty if none
// of the directions tried is free.
std::optional<Configuration> lift_off(const ScaledProblem& problem, SegmentTest& test,
                                      const Configuration& q, double tolerance);

}  // namespace planner
