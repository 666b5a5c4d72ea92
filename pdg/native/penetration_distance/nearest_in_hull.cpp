#include "nearest_in_hull.hpp"

#include <cmath>
#include <optional>
#include <utility>

#include "pdg/native/convex_sets/vectors.hpp"
#include "pdg/native/tolerances.hpp"

namespace pdg {
namespace {

// Weights of the affine hull's point nearest to the origin: (G + s 1 1^T) x = 1 scaled to sum 1, G
// the points' inner products and s their scale; by Cholesky. None if G is singular to rounding.
std::optional<std::vector<double>> affine_weights(const Corral& corral) {
  const std::size_t k = corral.size();
  double scale = 0.0;
  for (std::size_t i = 0; i < k; ++i) {
    scale = std::max(scale, dot(corral.point(i), corral.point(i)));
  }
  if (!(scale > 0.0)) return std::vector<double>(k, 1.0 / static_cast<double>(k));
  std::vector<double> l(k * k);
  for (std::size_t i = 0; i < k; ++i) {
    for (std::size_t j = 0; j <= i; ++j) {
      double sum = dot(corral.point(i), corral.point(j)) / scale + 1.0;
      for (std::size_t m = 0; m < j; ++m) sum -= l[i * k + m] * l[j * k + m];
      if (i == j) {
        if (!(sum > kSingularPivotUnits * static_cast<double>(k) * kUnitRoundoff)) return {};
        l[i * k + i] = std::sqrt(sum);
      } else {
        l[i * k + j] = sum / l[j * k + j];
      }
    }
  }
  std::vector<double> x(k, 1.0);
  for (std::size_t i = 0; i < k; ++i) {
    for (std::size_t m = 0; m < i; ++m) x[i] -= l[i * k + m] * x[m];
    x[i] /= l[i * k + i];
  }
  for (std::size_t i = k; i-- > 0;) {
    for (std::size_t m = i + 1; m < k; ++m) x[i] -= l[m * k + i] * x[m];
    x[i] /= l[i * k + i];
  }
  double sum = 0.0;
  for (const double w : x) sum += w;
  if (!(sum > 0.0) || !std::isfinite(sum)) return {};
  for (double& w : x) w /= sum;
  return x;
}

void set_nearest(Corral& corral) {
  corral.nearest.assign(corral.dimension, 0.0);
  for (std::size_t k = 0; k < corral.size(); ++k) {
    for (std::size_t i = 0; i < corral.dimension; ++i) {
      corral.nearest[i] += corral.weights[k] * corral.point(k)[i];
    }
  }
}

void drop(Corral& corral, const std::size_t k) {
  const auto n = static_cast<std::ptrdiff_t>(corral.dimension);
  const auto first = corral.points.begin() + static_cast<std::ptrdiff_t>(k) * n;
  corral.points.erase(first, first + n);
  corral.weights.erase(corral.weights.begin() + static_cast<std::ptrdiff_t>(k));
}

}  // namespace

Corral single_point(const std::span<const double> point) {
  Corral corral{point.size(), {point.begin(), point.end()}, {1.0}, {}};
  set_nearest(corral);
  return corral;
}

bool take_in(Corral& corral, const std::span<const double> point) {
  Corral grown = corral;
  grown.points.insert(grown.points.end(), point.begin(), point.end());
  grown.weights.push_back(0.0);
  for (;;) {
    const std::optional<std::vector<double>> target = affine_weights(grown);
    if (!target) return false;
    // As far towards the affine hull's nearest point as all weights stay >= 0.
    double step = 1.0;
    std::size_t out = grown.size();
    for (std::size_t k = 0; k < grown.size(); ++k) {
      if ((*target)[k] > 0.0) continue;
      const double reach = grown.weights[k] / (grown.weights[k] - (*target)[k]);
      if (out == grown.size() || reach < step) {
        step = reach;
        out = k;
      }
    }
    if (out == grown.size()) {
      grown.weights = *target;
      break;
    }
    for (std::size_t k = 0; k < grown.size(); ++k) {
      grown.weights[k] += step * ((*target)[k] - grown.weights[k]);
    }
    if (out + 1 == grown.size() && step == 0.0) return false;  // the new point has no use
    drop(grown, out);
  }
  set_nearest(grown);
  corral = std::move(grown);
  return true;
}

}  // namespace pdg
