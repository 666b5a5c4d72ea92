// Labels of cells, faces and segments: FREE and FULL hold for every configuration of the closed
// set, in exact arithmetic; everything else is MIXED.
#pragma once

#include <cstdint>
#include <vector>

#include "constraints.hpp"
#include "pdg/native/geometry/motion.hpp"
#include "planar_planner/native/ablation.hpp"
#include "planar_planner/native/statistics.hpp"
#include "planar_planner/native/world/obstacle_tree.hpp"
#include "planar_planner/native/world/posed_robot.hpp"

namespace planner {

enum class Label : std::uint8_t {
  kFree,   // every configuration free
  kStar,   // the free part is star-shaped about a guard (star.hpp)
  kFull,   // every configuration in C-obstacle, by one pair of pieces or by several together
  kMixed,  // undecided
};

struct Witness {
  std::uint32_t obstacle;  // piece of the obstacle tree
  std::uint16_t robot;     // piece of the robot
};

// The label of a set by single pairs: kFree, kFull or kMixed.
struct LabelResult {
  Label label = Label::kMixed;
  Witness witness{};         // kFull
  ConstraintList undecided;  // kMixed: for parts of the set
  double clearance = 0.0;    // lower bound over the pairs dropped here (planner units)
  double separation = 0.0;   // kMixed: estimate at the centre, least over pairs; a hint, no bound
  pdg::Sway sway;            // kMixed: summed over the undecided pairs
  double turning_radius = 0.0;  // kMixed: largest radius of the robot pieces still active
};

// Labels sets by single pairs of pieces. Owns the memory that it works in, and the count of pairs
// that were looked at; one per search.
class Labeller {
 public:
  Labeller(const Robot& robot, ObstacleTree& tree, Statistics& statistics,
           const Ablation& ablation = {});

  // Everything that can touch the robot, to start from.
  void root_list(ConstraintList& out) const;

  // Judges the motion against what `parent`, the list of a set that holds it, left undecided;
  // `posed` is turned to its central rotation. The memory of `room` is used for the new list.
  LabelResult label(const pdg::Motion& motion, PosedRobot& posed, const ConstraintView& parent,
                    ConstraintList room = {});

  // Pairs of pieces looked at so far, each counted once.
  [[nodiscard]] std::uint64_t pairs_touched() const { return pairs_touched_; }

  [[nodiscard]] const Robot& robot() const { return robot_; }
  [[nodiscard]] const ObstacleTree& tree() const { return tree_; }
  [[nodiscard]] const Ablation& ablation() const { return ablation_; }

 private:
  struct Pass;

  bool visit_node(Pass& pass, std::uint32_t node);
  bool apart_from_hull(Pass& pass, std::uint32_t node);
  bool visit_piece(Pass& pass, std::uint32_t piece);
  [[nodiscard]] double opening(Vec2 extent, Vec2 between, double radii) const;
  bool visit_closed_pair(Pass& pass, std::uint32_t obstacle, std::uint16_t robot);
  bool judge(Pass& pass, std::uint32_t obstacle, std::uint16_t robot,
             std::span<const pdg::Constraint> active);
  [[nodiscard]] bool culls(const Pass& pass, std::uint32_t obstacle, std::uint16_t robot) const;

  const Robot& robot_;
  ObstacleTree& tree_;
  Statistics& statistics_;
  Ablation ablation_;
  std::vector<pdg::Constraint> fresh_, undecided_;
  std::vector<bool> touched_;  // by obstacle piece: its pairs with all robot pieces
  std::uint64_t pairs_touched_ = 0;
};

}  // namespace planner
