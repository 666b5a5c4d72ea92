#include "enclosing_circle.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <random>
#include <span>
#include <utility>

#include "tolerances.hpp"

namespace pdg {
namespace {

constexpr std::minstd_rand::result_type kShuffleSeed = 1;

// The circle through the points that it rests on, and its centre as their weighted mean.
struct Supported {
  std::array<Vec2, 3> support{};
  std::array<double, 3> weights{1.0, 0.0, 0.0};
  Vec2 centre;
  double radius = 0.0;
};

bool holds(const Supported& circle, const Vec2 p) {
  return norm(p - circle.centre) <= circle.radius * kRadiusPadding;
}

Vec2 weighted_mean(const Supported& circle) {
  const auto& [a, b, c] = circle.support;
  return a + circle.weights[1] * (b - a) + circle.weights[2] * (c - a);
}

Supported at(const Vec2 a) {
  return {{a, a, a}, {1.0, 0.0, 0.0}, a, 0.0};
}

Supported through(const Vec2 a, const Vec2 b) {
  return {{a, b, a}, {0.5, 0.5, 0.0}, a + 0.5 * (b - a), 0.5 * norm(b - a)};
}

// The circle through three points; through the farthest two if they are on a line. With p, q, r the
// squared sides opposite, the weights are p (q + r - p) and so on; an obtuse angle's is negative.
Supported through(const Vec2 a, const Vec2 b, const Vec2 c) {
  double p = dot(b - c, b - c);
  double q = dot(c - a, c - a);
  double r = dot(a - b, a - b);
  const double longest = std::max({p, q, r});
  if (longest == 0.0) return at(a);
  // Scaled, so that the products below neither over- nor underflow.
  p /= longest;
  q /= longest;
  r /= longest;
  const std::array<double, 3> weights{p * (q + r - p), q * (r + p - q), r * (p + q - r)};
  const double sum = weights[0] + weights[1] + weights[2];
  if (sum <= 0.0) return p == 1.0 ? through(b, c) : q == 1.0 ? through(c, a) : through(a, b);
  Supported circle{{a, b, c}, {weights[0] / sum, weights[1] / sum, weights[2] / sum}, {}, 0.0};
  circle.centre = weighted_mean(circle);
  circle.radius = norm(a - circle.centre);
  return circle;
}

Supported round_with(const std::span<const Vec2> points, const Vec2 first, const Vec2 second) {
  Supported circle = through(first, second);
  for (const Vec2 p : points) {
    if (!holds(circle, p)) circle = through(first, second, p);
  }
  return circle;
}

Supported round_with(const std::span<const Vec2> points, const Vec2 first) {
  Supported circle = at(first);
  for (std::size_t k = 0; k < points.size(); ++k) {
    if (!holds(circle, points[k])) circle = round_with(points.first(k), first, points[k]);
  }
  return circle;
}

Supported smallest(std::vector<Vec2> points) {
  // The same numbers each time, and everywhere: std::shuffle's use of them would not be.
  std::minstd_rand order(kShuffleSeed);  // NOLINT(bugprone-random-generator-seed)
  for (std::size_t k = points.size(); k > 1; --k) std::swap(points[k - 1], points[order() % k]);
  Supported circle;
  for (std::size_t k = 0; k < points.size(); ++k) {
    if (k == 0 || !holds(circle, points[k])) {
      circle = round_with(std::span(points).first(k), points[k]);
    }
  }
  return circle;
}

}  // namespace

Circle smallest_enclosing_circle(std::vector<Vec2> points) {
  const Supported circle = smallest(std::move(points));
  return {circle.centre, circle.radius};
}

CircleBounds enclosing_circle_bounds(const std::vector<Vec2>& points) {
  Supported circle = smallest(points);
  // Of the smallest circle no weight is negative but by rounding.
  double sum = 0.0;
  for (double& w : circle.weights) {
    w = std::max(0.0, w);
    sum += w;
  }
  for (double& w : circle.weights) w /= sum;
  CircleBounds bounds;
  bounds.centre = weighted_mean(circle);
  double mean = 0.0;
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec2 from = circle.support[k] - bounds.centre;
    mean += circle.weights[k] * dot(from, from);
  }
  bounds.inner = std::sqrt(mean) / kRadiusPadding;
  for (const Vec2 p : points) {
    bounds.outer = std::max(bounds.outer, norm(p - bounds.centre) * kRadiusPadding);
  }
  return bounds;
}

}  // namespace pdg
