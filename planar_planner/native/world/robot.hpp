// The robot as convex pieces in its own frame, scaled to planner units.
#pragma once

#include <cstdint>
#include <vector>

#include "pdg/native/geometry/convex_piece.hpp"
#include "pdg/native/geometry/motion.hpp"
#include "pdg/native/separation/separation.hpp"
#include "scene.hpp"

namespace planner {

// pieces.back() is the convex hull, used against the workspace's walls only.
struct Robot {
  std::vector<pdg::ConvexPiece> pieces;
  std::vector<std::uint32_t> polygon_of_piece;  // index into the scene's robot polygons; hull: 0
  std::vector<std::uint32_t> first_vertex;      // of each piece in PosedRobot's arrays, and the end
  std::size_t vertex_total = 0;
  double reach = 0.0;  // max |a|, rounded up
  double inner_reach =
      0.0;  // radius of a disc about the origin inside one piece, rounded down; or 0
  std::uint16_t inner_piece = 0;  // that piece
  double hull_distance = 0.0;     // distance of the origin from the hull, rounded up; 0 inside

  [[nodiscard]] std::size_t body_pieces() const { return pieces.size() - 1; }
  [[nodiscard]] std::uint16_t hull() const { return static_cast<std::uint16_t>(pieces.size() - 1); }
};

Robot make_robot(const PolygonSet& polygons, int exponent, bool partition = true);

void pose(const Robot& robot, pdg::Rotation rotation, pdg::PosedRobot& out);

void turn_piece(const Robot& robot, const pdg::PosedRobot& posed, std::size_t piece);

inline pdg::PosedPiece posed_piece(const Robot& robot, const pdg::PosedRobot& posed,
                                   const std::size_t piece) {
  if (posed.turned[piece] == 0) turn_piece(robot, posed, piece);
  const std::size_t first = robot.first_vertex[piece];
  const std::size_t count = robot.first_vertex[piece + 1] - first;
  return {&robot.pieces[piece],
          {posed.vertices.data() + first, count},
          {posed.normals.data() + first, count},
          pdg::rotate(posed.rotation, robot.pieces[piece].inner_centre)};
}

}  // namespace planner
