// Pairs of pieces that come near each other somewhere in a motion, walls included: what labelling
// visits, without the labels. Opens the obstacle tree as it goes.
#pragma once

#include <algorithm>
#include <cmath>

#include "pdg/native/geometry/motion.hpp"
#include "pdg/native/separation/separation.hpp"
#include "pdg/native/tolerances.hpp"
#include "planar_planner/native/world/obstacle_tree.hpp"
#include "planar_planner/native/world/robot.hpp"

namespace planner {

// Distance from the motion's translations to a rectangle, up to rounding.
inline double distance_to_box(const pdg::Motion& m, const Vec2 low, const Vec2 high) {
  const Vec2 extent = box_extent(m);
  const double dx = std::max({low.x - m.t.x, m.t.x - high.x, 0.0}) - extent.x;
  const double dy = std::max({low.y - m.t.y, m.t.y - high.y, 0.0}) - extent.y;
  return pdg::norm({std::max(dx, 0.0), std::max(dy, 0.0)});
}

// Lower bound of the distance between the robot and whatever is in the node, over the motion.
inline double node_gap(const pdg::Motion& m, const double robot_reach, const TreeNode& node) {
  const double largest = std::max(std::max(std::abs(node.low.x), std::abs(node.high.x)),
                                  std::max(std::abs(node.low.y), std::abs(node.high.y)));
  const double error =
      pdg::kSeparationErrorUnits * pdg::kUnitRoundoff * (robot_reach + m.reach + largest);
  return distance_to_box(m, node.low, node.high) - robot_reach - error;
}

// The vector from the centre of b's bounding circle to that of a's, in the middle of the motion.
inline Vec2 between_circles(const pdg::Motion& m, const pdg::Rotation rotation,
                            const pdg::ConvexPiece& a, const pdg::ConvexPiece& b) {
  return m.t + pdg::rotate(rotation, a.centre) - b.centre;
}

// Lower bound of the distance between the pieces' bounding circles over the motion, up to rounding.
inline double circle_distance(const pdg::Motion& m, const Vec2 d, const pdg::ConvexPiece& a,
                              const pdg::ConvexPiece& b) {
  const Vec2 extent = box_extent(m);
  const double dx = std::max(std::abs(d.x) - extent.x, 0.0);
  const double dy = std::max(std::abs(d.y) - extent.y, 0.0);
  // |R(theta + delta) c - R(theta) c| = 2 |c| sin(|delta| / 2) <= |c| |delta|
  return pdg::norm({dx, dy}) - pdg::norm(a.centre) * m.half_angle - a.radius - b.radius;
}

inline double circle_distance(const pdg::Motion& m, const pdg::Rotation rotation,
                              const pdg::ConvexPiece& a, const pdg::ConvexPiece& b) {
  return circle_distance(m, between_circles(m, rotation, a, b), a, b);
}

// Lower bound of the distance between the pieces over the motion.
inline double circle_gap(const pdg::Motion& m, const Vec2 between, const pdg::ConvexPiece& a,
                         const pdg::ConvexPiece& b) {
  return circle_distance(m, between, a, b) - pdg::separation_error(a, b, m);
}
inline double circle_gap(const pdg::Motion& m, const pdg::Rotation rotation,
                         const pdg::ConvexPiece& a, const pdg::ConvexPiece& b) {
  return circle_gap(m, between_circles(m, rotation, a, b), a, b);
}

// Calls visit(obstacle piece, robot piece) for every pair whose circles may come nearer than
// `within` (planner units); every other pair is at least that far apart. Nodes for which settled()
// holds are not opened.
template <class Visit, class Settled>
void visit_node_pairs(const Robot& robot, ObstacleTree& tree, const std::uint32_t index,
                      const pdg::Motion& motion, const pdg::Rotation rotation, const double within,
                      const Visit& visit, const Settled& settled) {
  if (node_gap(motion, robot.reach, tree.node(index)) >= within || settled(index)) return;
  tree.expand(index);
  if (tree.node(index).piece == kNoPiece) {
    const std::uint32_t left = tree.node(index).left;
    for (const std::uint32_t child : {left, left + 1})
      visit_node_pairs(robot, tree, child, motion, rotation, within, visit, settled);
    return;
  }
  const std::uint32_t piece = tree.node(index).piece;
  for (std::size_t i = 0; i < robot.body_pieces(); ++i)
    if (circle_gap(motion, rotation, robot.pieces[i], tree.piece(piece)) < within) visit(piece, i);
}

template <class Visit, class Settled>
void visit_nearby_pairs(const Robot& robot, ObstacleTree& tree, const pdg::Motion& motion,
                        const pdg::Rotation rotation, const double within, const Visit& visit,
                        const Settled& settled) {
  for (std::uint32_t wall = 0; wall < tree.wall_count(); ++wall) visit(wall, robot.hull());
  if (!tree.empty())
    visit_node_pairs(robot, tree, tree.root(), motion, rotation, within, visit, settled);
}

template <class Visit>
void visit_nearby_pairs(const Robot& robot, ObstacleTree& tree, const pdg::Motion& motion,
                        const pdg::Rotation rotation, const double within, const Visit& visit) {
  visit_nearby_pairs(robot, tree, motion, rotation, within, visit,
                     [](std::uint32_t) { return false; });
}

}  // namespace planner
