#include "motion_bound.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "pdg/native/tolerances.hpp"

namespace pdg {

// Each expression has at most 8 roundings of relative error u on nonnegative terms (hypot 2,
// sine and its argument 4, product 1, sum 1), which kRadiusPadding covers.

double sum_bound(const HalfExtents& h, const double r) {
  return (h.x + h.y + r * h.theta) * kRadiusPadding;
}

double arc_bound(const HalfExtents& h, const double r) {
  return (std::hypot(h.x, h.y) + r * h.theta) * kRadiusPadding;
}

double displacement_bound(const HalfExtents& h, const double r) {
  const double half_angle = 0.5 * std::min(h.theta, std::numbers::pi);
  return (std::hypot(h.x, h.y) + 2.0 * r * std::sin(half_angle)) * kRadiusPadding;
}

}  // namespace pdg
