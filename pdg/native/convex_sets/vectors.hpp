// Vectors of R^n as spans of coordinates. Plain doubles, summed in the order of the coordinates.
#pragma once

#include <cmath>
#include <cstddef>
#include <span>

namespace pdg {

inline double dot(const std::span<const double> a, const std::span<const double> b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
  return sum;
}

inline double norm(const std::span<const double> a) {
  return std::sqrt(dot(a, a));
}

// sum |a_i| weight_i.
inline double weighted_norm(const std::span<const double> a, const std::span<const double> weight) {
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += std::abs(a[i]) * weight[i];
  return sum;
}

}  // namespace pdg
