// The C-obstacle queries that are compared, each for one cell: is all of it in C-obstacle?
//
// From scratch (published, displacement, alone): the pairs of pieces whose bounding circles meet at
// the cell's centre, from the obstacles' hierarchy, one after another until one proves the cell.
// Inherited (label, joint): the pairs and axes that the parent cell left undecided, as the planner
// does it; `joint` adds what several pairs prove together.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "planar_planner/native/configurations/dyadic_box.hpp"
#include "planar_planner/native/labels/classify.hpp"
#include "planar_planner/native/world/scaled_problem.hpp"

namespace bench {

enum class Query : std::uint8_t { kPublished, kDisplacement, kAlone, kLabel, kSingle, kJoint };
inline constexpr std::size_t kQueries = 6;
inline constexpr std::array<const char*, kQueries> kQueryNames{
    "published",  "displacement",      "per_normal_alone",
    "per_normal", "per_normal_single", "per_normal_joint"};

// The planner's parts, put together by hand.
struct World {
  World(planner::Problem scene, const planner::Ablation& ablation, double fixed_theta);
  World(const World&) = delete;
  World& operator=(const World&) = delete;

  // The robot at a rotation, until the next call.
  planner::PosedRobot& posed_at(const pdg::Rotation rotation) {
    posed.turn_to(rotation);
    return posed;
  }

  planner::ScaledProblem problem;
  planner::ObstacleTree tree;
  planner::Statistics statistics;
  planner::Labeller labeller;
  planner::PosedRobot posed;
  planner::CellSpace space;
  // Scratch of the queries below.
  std::vector<planner::Witness> near;
  std::vector<pdg::Constraint> all, left;
  planner::ConstraintList list, chosen;
  planner::Scratch scratch;
};

// One cell of a walk, and what its parent left undecided.
struct Visit {
  planner::Extent box;
  std::shared_ptr<const planner::ConstraintList> parent;
};

// By several pairs of the list together.
bool obstructed(World& world, const pdg::Motion& motion, planner::PosedRobot& posed,
                const planner::ConstraintList& list);

bool proves(World& world, const Visit& visit, Query query);

}  // namespace bench
