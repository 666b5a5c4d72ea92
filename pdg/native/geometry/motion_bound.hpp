// Upper bounds on how far a body can move when its configuration goes from a cell's centre to any
// point of the cell. Half-extents h.x, h.y (length) and h.theta (radians), all >= 0; r is the
// largest distance of the body's points from the reference point (length): of the whole body, or
// of one convex piece where the bound is used for that piece alone.
//
// All three are rounded up, so they hold for the exact numbers given.
#pragma once

namespace pdg {

struct HalfExtents {
  double x = 0.0;
  double y = 0.0;
  double theta = 0.0;
};

// [PDG] Eq. 3: h_x + h_y + r h_theta. Bounds D_g (so arc length and displacement too).
double sum_bound(const HalfExtents& h, double r);

// sqrt(h_x^2 + h_y^2) + r h_theta. Bounds D_g: translate straight while turning evenly.
double arc_bound(const HalfExtents& h, double r);

// sqrt(h_x^2 + h_y^2) + 2 r sin(min(h_theta, pi) / 2). Bounds the displacement metric DISP, not
// D_g; sound in the C-obstacle query, because max PD^t over pairs bounds depth under DISP too.
double displacement_bound(const HalfExtents& h, double r);

}  // namespace pdg
