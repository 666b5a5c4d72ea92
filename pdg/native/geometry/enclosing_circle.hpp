// The smallest circle round points, and round points that count as farther than they are.
#pragma once

#include <array>
#include <vector>

#include "vec.hpp"

namespace pdg {

struct WeightedPoint {
  Vec2 p;
  double weight = 0.0;  // >= 0, a squared length
};

// The c that minimises max |p_i - c|^2 + weight_i, which is unique, and the at most three points
// that determine it: c = sum of share_i p_i, shares >= 0. Plain doubles.
struct WeightedCentre {
  Vec2 c;
  int support_size = 0;
  std::array<WeightedPoint, 3> support{};
  std::array<double, 3> shares{};
};

// Deterministic. At least one point.
WeightedCentre weighted_centre(const std::vector<WeightedPoint>& points);

// For any shares >= 0 with sum s: sum over i < j of share_i share_j |p_i - p_j|^2 / s^2 is at most
// the squared radius of the smallest circle round the p_i (its dual), and equal for the right
// shares. No cancellation, wherever the points lie: this radius is rounded down.
double radius_from_below(const WeightedCentre& centre);

struct Circle {
  Vec2 centre;
  double radius = 0.0;
};

// Plain doubles: no point lies outside by more than a few u of the radius. A turn by phi moves some
// point round which the circle is drawn by 2 sin(|phi| / 2) radius at least, whatever the
// translation.
Circle smallest_enclosing_circle(const std::vector<Vec2>& points);

// The same with both sides of its radius. For any shares l >= 0 of sum 1, and c* = sum l_v v,
//   max_v |t + v - c*|^2 >= sum l_v |t + v - c*|^2 = |t|^2 + rho^2,  rho^2 = sum l_v |v - c*|^2,
// for every t: about c* itself, be it the best centre or not. `inner` <= rho, so it bounds the
// radius of every enclosing circle too. About `centre` this holds up to the distance to c*.
struct CircleBounds {
  Vec2 centre;         // c* up to 8 u max |v|
  double inner = 0.0;  // rounded down
  double outer = 0.0;  // max |v - centre|, rounded up. Above `inner` by what rounding does to the
                       // shares: some u of it, a thousand u for slivers. Nothing leans on how much.
};

CircleBounds enclosing_circle_bounds(const std::vector<Vec2>& points);

}  // namespace pdg
