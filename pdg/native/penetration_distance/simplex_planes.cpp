#include "simplex_planes.hpp"

#include <algorithm>
#include <cmath>

namespace pdg {
namespace {

// In place, Gauss-Jordan with partial pivoting; false if singular.
bool invert(std::vector<double>& m, const std::size_t n) {
  std::vector<double> inverse(n * n);
  for (std::size_t i = 0; i < n; ++i) inverse[i * n + i] = 1.0;
  for (std::size_t column = 0; column < n; ++column) {
    std::size_t pivot = column;
    for (std::size_t i = column + 1; i < n; ++i) {
      if (std::abs(m[i * n + column]) > std::abs(m[pivot * n + column])) pivot = i;
    }
    const double value = m[pivot * n + column];
    if (value == 0.0) return false;
    for (std::size_t j = 0; j < n; ++j) {
      std::swap(m[pivot * n + j], m[column * n + j]);
      std::swap(inverse[pivot * n + j], inverse[column * n + j]);
      m[column * n + j] /= value;
      inverse[column * n + j] /= value;
    }
    for (std::size_t i = 0; i < n; ++i) {
      if (i == column) continue;
      const double factor = m[i * n + column];
      for (std::size_t j = 0; j < n; ++j) {
        m[i * n + j] -= factor * m[column * n + j];
        inverse[i * n + j] -= factor * inverse[column * n + j];
      }
    }
  }
  m = std::move(inverse);
  return true;
}

}  // namespace

std::optional<SimplexPlanes> simplex_planes(const std::size_t n,
                                            const std::span<const double> points) {
  SimplexPlanes result{std::vector<double>(n), std::vector<double>((n + 1) * (n + 1))};
  const double share = 1.0 / static_cast<double>(n + 1);
  for (std::size_t p = 0; p <= n; ++p) {
    for (std::size_t i = 0; i < n; ++i) result.centre[i] += share * points[p * n + i];
  }
  // The barycentric coordinate of point j (j >= 1) has the gradient that is row j - 1 of the
  // inverse of the matrix with columns p_j - p_0; those of all points sum to 0.
  std::vector<double> edges(n * n);
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < n; ++j) edges[i * n + j] = points[(j + 1) * n + i] - points[i];
  }
  if (!invert(edges, n)) return std::nullopt;
  for (std::size_t i = 0; i < n; ++i) {
    double sum = 0.0;
    for (std::size_t j = 1; j <= n; ++j) {
      const double gradient = edges[(j - 1) * n + i];
      sum += gradient;
      result.planes[j * (n + 1) + i] = -static_cast<double>(n + 1) * gradient;
    }
    result.planes[i] = static_cast<double>(n + 1) * sum;
  }
  for (std::size_t j = 0; j <= n; ++j) {
    double* const plane = result.planes.data() + j * (n + 1);
    plane[n] = 1.0;
    for (std::size_t i = 0; i < n; ++i) plane[n] += plane[i] * result.centre[i];
  }
  return result;
}

}  // namespace pdg
