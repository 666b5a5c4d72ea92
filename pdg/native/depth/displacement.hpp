// Distances between two configurations of one body: the displacement metric DISP and bounds of the
// generalized distance D_g ([PDG] section 3.2). docs/pdg.md has the proofs.
#pragma once

#include "pdg/native/pieces/piece_set.hpp"

namespace pdg {

// DISP(q0, q1) = max over body points of |A(q1) - A(q0)|. The displacement is a convex function of
// the body point, so a hull vertex attains it. Plain doubles, off by at most
// kDisplacementErrorUnits.
double displacement(const PieceSet& body, const Pose& from, const Pose& to);

// Bounds of D_g, rounded outward, so that they hold for the exact doubles given. With w = |dtheta|
// modulo full turns, in [0, pi], k = 2 sin(w / 2), and rho, m the radius and centre of the smallest
// circle round the body:
//   D_g >= max(DISP, w rho)
//   D_g <= sqrt(max over vertices v of |dv|^2 + (w^2 - k^2) |v - c|^2), any point c of the frame.
// The second is attained by no longer trajectories when c moves straight while the body turns
// evenly. c is chosen to make it least, so it is at most sqrt(DISP^2 + (w^2 - k^2) rho^2) (c = m),
// the pole's arc (c = the pole) and |dc| + w max |v - c| for every c ([PDG] Eq. 4, one rotation).
struct DistanceBounds {
  double lower = 0.0;
  double upper = 0.0;
  Vec2 centre;  // c, in the body's frame
};

DistanceBounds generalized_distance_bounds(const PieceSet& body, const Pose& from, const Pose& to);

}  // namespace pdg
