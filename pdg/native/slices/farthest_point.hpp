// The convex function f(t) = max over v of |t + w_v|: what a slice at one angle is minimised under.
// w = {0} gives the length of a translation (PD^t); w_v = (R(theta) - R(theta0)) (v - c), over the
// vertices v of the moving body's hull, gives its displacement DISP when t is the translation of
// the body's point c. Plain doubles: values are good to some 8 u (|t| + max |w|).
#pragma once

#include <vector>

#include "pdg/native/geometry/vec.hpp"

namespace pdg {

// foot + s * along, `along` of unit length.
struct Line {
  Vec2 foot;
  Vec2 along;
};

constexpr Vec2 point_at(const Line& line, const double s) {
  return line.foot + s * line.along;
}

// Invariant: the smallest circle that encloses the points w_v is centred at 0. Then every t has a
// w_v with |w_v| = radius and w_v . t >= 0, so hypot(|t|, radius) <= f(t) <= |t| + radius, and f is
// least at t = 0.
struct FarthestPoint {
  std::vector<Vec2> offsets{Vec2{}};  // w_v
  double radius = 0.0;                // of that circle: the least value

  [[nodiscard]] double value(Vec2 t) const;

  // Where f is least on the stretch [low, high] of a line, low <= high finite.
  [[nodiscard]] double least_on(const Line& line, double low, double high) const;

  // Rounded up: f(t) <= value only where |t| is at most this; 0 when value < radius.
  [[nodiscard]] double reach(double value) const;
};

}  // namespace pdg
