// The centre that is nearest to all of several weighted points: a smallest enclosing circle whose
// points may count as farther than they are.
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
// shares. No cancellation: this radius is rounded down.
double radius_from_below(const WeightedCentre& centre);

}  // namespace pdg
