// Does the robot overlap anything in one configuration? In plain doubles, without margins: a hint
// that steers a search and proves nothing. In a large scene polygons that nobody has decomposed yet
// stay so: their edges are asked.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "pdg/native/geometry/motion.hpp"
#include "planar_planner/native/configurations/edge_runs.hpp"
#include "planar_planner/native/configurations/scaled_configuration.hpp"
#include "planar_planner/native/world/obstacle_tree.hpp"
#include "planar_planner/native/world/scaled_problem.hpp"
#include "tuning.hpp"

namespace planner {

inline constexpr double kCollides = -1.0;

class CollisionHint {
 public:
  // Scenes with more obstacle vertices than `small` are large.
  CollisionHint(const ScaledProblem& problem, ObstacleTree& tree, std::size_t small = kSmallScene);

  // How far every point of the robot may move and meet nothing, by bounding boxes, circles and the
  // first axis that separates a pair: never too much. kCollides if the robot overlaps something, or
  // the reference point is out of its domain.
  double gap(const ScaledConfiguration& q);

  // Calls of gap.
  [[nodiscard]] std::uint64_t calls() const { return calls_; }
  // Boxes, edges and pairs of pieces looked at so far, about a nanosecond or two each.
  [[nodiscard]] std::uint64_t work() const { return work_; }

 private:
  [[nodiscard]] double gap_to_domain() const;
  [[nodiscard]] double gap_to_walls() const;
  void place_hull();
  // Each of these: kCollides, or how far every point of the robot may move at least.
  double gap_to_last_piece();
  double gap_to_node(std::uint32_t node);
  double gap_to_piece(const pdg::ConvexPiece& obstacle);
  double gap_to_polygon(std::uint32_t polygon);
  double separation(std::size_t piece, const pdg::ConvexPiece& obstacle);
  bool crosses(Vec2 p, Vec2 q);
  [[nodiscard]] double gap_to_box(const TreeNode& node) const;
  void turn(std::size_t piece);

  const ScaledProblem& problem_;
  ObstacleTree& tree_;
  bool small_;                                  // a scene whose polygons are all decomposed
  std::vector<Vec2> vertices_, normals_;        // of the robot's pieces, turned but not moved
  std::vector<std::uint64_t> turned_at_;        // by piece: the call that turned it last
  std::vector<std::uint32_t> open_;             // nodes still to visit
  std::vector<std::optional<EdgeRuns>> edges_;  // by polygon, made when first asked
  std::uint64_t calls_ = 0;
  std::uint64_t work_ = 0;
  std::uint32_t last_hit_ = kNoPiece;  // node

  // What belongs to the configuration that is asked about.
  Vec2 t_;
  pdg::Rotation rotation_;
  Vec2 low_, high_;  // bounds of the robot
};

}  // namespace planner
