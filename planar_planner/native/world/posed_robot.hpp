// The robot turned to one rotation, its reference point at the origin. Pieces are turned when they
// are first asked for, because most of them never come near an obstacle.
#pragma once

#include <cstddef>
#include <vector>

#include "pdg/native/geometry/motion.hpp"
#include "pdg/native/separation/separation.hpp"
#include "robot.hpp"

namespace planner {

// Owns the turned vertices. At first the robot is as it was given.
class PosedRobot {
 public:
  // The robot must outlive it.
  explicit PosedRobot(const Robot& robot);

  // Pieces handed out before are no longer valid, unless the rotation is the same.
  void turn_to(pdg::Rotation rotation);
  [[nodiscard]] pdg::Rotation rotation() const { return rotation_; }

  // Valid until the robot is turned to another rotation.
  [[nodiscard]] pdg::PosedPiece piece(const std::size_t i) {
    if (turned_[i] == 0) turn_piece(i);
    const std::size_t first = robot_->first_vertex[i];
    const std::size_t count = robot_->first_vertex[i + 1] - first;
    return {&robot_->pieces[i],
            {vertices_.data() + first, count},
            {normals_.data() + first, count},
            pdg::rotate(rotation_, robot_->pieces[i].inner_centre)};
  }

 private:
  void turn_piece(std::size_t i);

  const Robot* robot_;
  pdg::Rotation rotation_;
  std::vector<Vec2> vertices_, normals_;  // of all pieces, one after another (Robot::first_vertex)
  std::vector<char> turned_;              // by piece: 1 if its vertices and normals are there
};

}  // namespace planner
