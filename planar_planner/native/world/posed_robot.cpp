#include "posed_robot.hpp"

#include <algorithm>

namespace planner {

PosedRobot::PosedRobot(const Robot& robot)
    : robot_(&robot),
      vertices_(robot.vertex_total),
      normals_(robot.vertex_total),
      turned_(robot.pieces.size(), 0) {}

void PosedRobot::turn_to(const pdg::Rotation rotation) {
  if (rotation.cos == rotation_.cos && rotation.sin == rotation_.sin) return;
  rotation_ = rotation;
  std::fill(turned_.begin(), turned_.end(), char{0});
}

void PosedRobot::turn_piece(const std::size_t i) {
  turned_[i] = 1;
  std::size_t at = robot_->first_vertex[i];
  for (const pdg::Edge& edge : robot_->pieces[i].edges) {
    vertices_[at] = pdg::rotate(rotation_, edge.vertex);
    normals_[at] = pdg::rotate(rotation_, edge.normal);
    ++at;
  }
}

}  // namespace planner
