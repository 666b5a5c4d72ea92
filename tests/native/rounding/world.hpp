// A whole scene, as the planner sees it and as it is.
#pragma once

#include <optional>
#include <vector>

#include "generate.hpp"
#include "planar_planner/native/labels/label.hpp"
#include "planar_planner/native/world/scaled_problem.hpp"
#include "truth/exact.hpp"

namespace rounding {

// The planner's parts, put together by hand, and the scene's exact pieces by the planner's indices.
class World {
 public:
  explicit World(planner::Problem scene, double theta = 0.0);
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

  std::vector<exact::Piece> robot;  // the hull is the last
  exact::Ball reach;                // max |a|
  std::vector<exact::Wall> walls;
  std::vector<std::vector<exact::Piece>> obstacles;  // by polygon

  // The obstacle piece that the tree has under this index; not a wall.
  [[nodiscard]] const exact::Piece& obstacle(std::uint32_t tree_piece) const;
  [[nodiscard]] std::size_t body_pieces() const { return robot.size() - 1; }
};

struct Stage {
  planner::Problem scene;
  std::optional<planner::Configuration> critical;  // where the robot is held from several sides
};

// Random shapes; a robot in a slot, or in a corner, of nearly its own size; all at any scale and
// far from the origin if adversarial.
Stage any_stage(Random& random, bool adversarial);

}  // namespace rounding
