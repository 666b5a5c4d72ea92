// Distances between two configurations of one body: the displacement metric DISP and bounds of the
// generalized distance D_g ([PDG] section 3.2).
#pragma once

#include "piece_set.hpp"

namespace pdg {

// DISP(q0, q1) = max over body points of |A(q1) - A(q0)|. The displacement is a convex function of
// the body point, so a hull vertex attains it. Plain doubles.
double displacement(const PieceSet& body, const Pose& from, const Pose& to);

struct DistanceBounds {
  double lower = 0.0;
  double upper = 0.0;
};

// DISP <= D_g <= the least of: turning about the pole of the relative motion,
// DISP (|dtheta| / 2) / sin(|dtheta| / 2), and moving a point c straight while turning about it,
// |dc| + r_c |dtheta|, for c the reference point and each vertex. |dtheta| <= pi is the angle
// modulo full turns. Plain doubles.
DistanceBounds generalized_distance_bounds(const PieceSet& body, const Pose& from, const Pose& to);

}  // namespace pdg
