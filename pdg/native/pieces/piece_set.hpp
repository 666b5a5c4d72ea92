// The convex pieces of one body with what the depth functions share.
#pragma once

#include <cstdint>
#include <vector>

#include "pdg/native/geometry/box_tree.hpp"
#include "pdg/native/geometry/convex_piece.hpp"
#include "pdg/native/geometry/motion.hpp"
#include "pdg/native/geometry/polygon.hpp"

namespace pdg {

// A rigid placement of a body, the configuration q of [PDG]: A(q) = R(theta) A + t, theta in
// radians about the frame origin.
struct Pose {
  Vec2 t;
  double theta = 0.0;
};

struct PieceSet {
  std::vector<ConvexPolygon> polygons;
  std::vector<ConvexPiece> pieces;  // the same, in the unshifted frame
  std::vector<double> radii;        // per piece: max |vertex| about the frame origin, rounded up
  double radius = 0.0;              // the largest of them
  BoxTree tree;                     // over the pieces' boxes
  ConvexPolygon hull;               // of all pieces
  ConvexPiece hull_piece;           // the same, in the unshifted frame
  std::vector<Polygon> outline;     // the polygons whose union the pieces are, where they are known
};

// Throws std::invalid_argument for a piece of more than 65535 vertices.
PieceSet make_piece_set(std::vector<ConvexPolygon> polygons);

// libm sine and cosine of the angle as given.
Rotation rotation_of(double theta);

// Vertices at the pose, in doubles: each coordinate is off by at most 8 u (|a| + |t|). At the zero
// pose they are the given ones.
ConvexPolygon placed(const ConvexPolygon& polygon, const Pose& pose);

}  // namespace pdg
