// The point of the convex hull of a few affinely independent points that is nearest to the origin.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace pdg {

// Points of R^n, one a row, with the weights of their combination that is nearest to the origin.
struct Corral {
  std::size_t dimension = 0;
  std::vector<double> points;
  std::vector<double> weights;  // > 0, sum 1
  std::vector<double> nearest;  // sum of weights times points

  [[nodiscard]] std::size_t size() const { return weights.size(); }
  [[nodiscard]] std::span<const double> point(const std::size_t k) const {
    return std::span(points).subspan(k * dimension, dimension);
  }
};

Corral single_point(std::span<const double> point);

// P. Wolfe, Finding the nearest point in a polytope, 1976: takes in a point on the origin's side of
// the plane through `nearest` across it, and drops those that have no weight any more. Returns
// false, and leaves the corral as it was, if the point is affinely dependent to within rounding.
bool take_in(Corral& corral, std::span<const double> point);

}  // namespace pdg
