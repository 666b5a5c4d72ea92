// The robot as convex pieces in its own frame, scaled to planner units.
#pragma once

#include <cstdint>
#include <vector>

#include "pdg/native/geometry/convex_piece.hpp"
#include "problem.hpp"

namespace planner {

// pieces.back() is the convex hull, used against the workspace's walls only.
struct Robot {
  std::vector<pdg::ConvexPiece> pieces;
  std::vector<std::uint32_t> polygon_of_piece;  // index into the scene's robot polygons; hull: 0
  std::vector<std::uint32_t> first_vertex;      // number of vertices before each piece, and in all
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

}  // namespace planner
