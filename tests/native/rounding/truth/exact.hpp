// What the core claims, decided anew: from the user's doubles and the cells' integers, by closed
// forms in ball arithmetic. Nothing that the core has rounded goes in, and none of its code is used
// but the frame and the domain's doubles, which define what a cell is.
#pragma once

#include <vector>

#include "ball.hpp"
#include "pdg/native/geometry/convex_piece.hpp"
#include "pdg/native/separation/separation.hpp"
#include "planar_planner/native/configurations/dyadic_box.hpp"
#include "planar_planner/native/world/problem.hpp"

namespace exact {

// Vertices counter-clockwise, in the frame of evaluation; edge k runs from vertex k to k + 1.
struct Piece {
  std::vector<Vector> vertices;
  std::vector<Vector> along;    // from vertex k to vertex k + 1, itself and not as a difference
  std::vector<Vector> normals;  // outward, of unit length
};

// A point of the user's frame, or of the robot's if the frame's origin is zero, in the frame.
Vector framed(const pdg::Frame& frame, pdg::Vec2 p);
Piece framed(const pdg::Frame& frame, const pdg::ConvexPolygon& polygon);
// The robot's frame of a problem: scaled only.
inline pdg::Frame robot_frame(const pdg::Frame& frame) {
  return {{}, frame.exponent};
}

// Translations t + s1 g1 + s2 g2 with |s1|, |s2| <= 1, rotations by `rotation` turned further by at
// most h.
struct Box {
  Vector t;
  Vector g1, g2;
  SineCosine rotation;
  Ball h;
  SineCosine half;  // of h, at most pi
};

// The cell or face of a domain, in the frame of evaluation.
Box box_of(const planner::CellSpace& space, const planner::Extent& extent);
// One configuration of the user.
Box point_of(const pdg::Frame& frame, pdg::Vec2 t, double theta);

// A straight motion: start + u along, theta + u turn, for u in [0, 1].
struct Way {
  Vector start, along;
  Ball theta, turn;
};
Way way_of(const pdg::Frame& frame, const planner::Configuration& from,
           const planner::Configuration& to);

// A stretch of a motion, begin <= u <= end.
struct Stretch {
  Ball begin, end;
};

// A separating-axis function: an edge of the piece of the robot or of the obstacle.
struct Axis {
  pdg::EdgeOwner owner;
  std::size_t edge;
};
std::vector<Axis> axes_of(const Piece& a, const Piece& b);
// Its least and its largest value over the box: attained, not only bounds.
Ball least_value(const Piece& a, const Piece& b, const Axis& axis, const Box& box);
Ball largest_value(const Piece& a, const Piece& b, const Axis& axis, const Box& box);
// A lower bound of its least value over a stretch: not below `wanted` if it is certain that no
// value is; else within `slack` of the least, unless kMostHalvings were not enough. By halving
// where the bounds are lowest: of each part, the uncoupled bound, or the expansion to first order
// about its middle with all remainders.
Ball least_value(const Piece& a, const Piece& b, const Axis& axis, const Way& way,
                 const Stretch& stretch, double wanted, double slack);

// Some axis separates (touching allowed) in every configuration, beyond doubt.
bool apart(const Piece& a, const Piece& b, const Box& box);
bool apart(const Piece& a, const Piece& b, const Way& way, const Stretch& stretch);
// The interiors meet in every configuration, beyond doubt.
bool overlap(const Piece& a, const Piece& b, const Box& box);
// Least over the configurations of the box of the depth by which the pieces overlap, from below:
// minus the largest value of any axis.
Ball least_depth(const Piece& a, const Piece& b, const Box& box);

// A wall: the solid half-plane n . p <= d with an axis-parallel n.
struct Wall {
  Vector normal;
  Ball offset;
};
Ball wall_least(const Piece& a, const Wall& wall, const Box& box);
Ball wall_largest(const Piece& a, const Wall& wall, const Box& box);

// Lower bounds of the distance over the box, by circles and boxes, in closed form.
Ball circle_distance(const Piece& a, const Piece& b, const Box& box);
Ball box_distance(const Ball& robot_reach, const Vector& low, const Vector& high, const Box& box);

// max |a|, and the bounding box's corners.
Ball reach(const Piece& a);
Vector low_corner(const Piece& a);
Vector high_corner(const Piece& a);

// v cos + w sin over |delta| <= h.
struct Sinusoid {
  Ball v, w;
};
Ball sinusoid_least(const Sinusoid& f, const Box& box);
Ball sinusoid_largest(const Sinusoid& f, const Box& box);

}  // namespace exact
