#include "enclosing_circle.hpp"

#include <algorithm>
#include <cstddef>
#include <random>
#include <span>

#include "tolerances.hpp"

namespace pdg {
namespace {

constexpr std::minstd_rand::result_type kShuffleSeed = 1;

bool holds(const Circle& circle, const Vec2 p) {
  return norm(p - circle.centre) <= circle.radius * kRadiusPadding;
}

Circle through(const Vec2 a, const Vec2 b) {
  return {0.5 * (a + b), 0.5 * norm(b - a)};
}

// The circle through three points; through the farthest two if they are on a line.
Circle through(const Vec2 a, const Vec2 b, const Vec2 c) {
  // Scaled, so that the cubes below neither over- nor underflow.
  const double scale = std::max(norm(b - a), norm(c - a));
  if (scale == 0.0) return {a, 0.0};
  const Vec2 u = (1.0 / scale) * (b - a);
  const Vec2 v = (1.0 / scale) * (c - a);
  const double twice = 2.0 * cross(u, v);
  if (twice == 0.0) {
    const Circle longest[] = {through(a, b), through(b, c), through(c, a)};
    return *std::max_element(std::begin(longest), std::end(longest),
                             [](const Circle& p, const Circle& q) { return p.radius < q.radius; });
  }
  const Vec2 to_centre =
      (scale / twice) * Vec2{v.y * dot(u, u) - u.y * dot(v, v), u.x * dot(v, v) - v.x * dot(u, u)};
  return {a + to_centre, norm(to_centre)};
}

Circle round_with(const std::span<const Vec2> points, const Vec2 first, const Vec2 second) {
  Circle circle = through(first, second);
  for (const Vec2 p : points) {
    if (!holds(circle, p)) circle = through(first, second, p);
  }
  return circle;
}

Circle round_with(const std::span<const Vec2> points, const Vec2 first) {
  Circle circle{first, 0.0};
  for (std::size_t k = 0; k < points.size(); ++k) {
    if (!holds(circle, points[k])) circle = round_with(points.first(k), first, points[k]);
  }
  return circle;
}

}  // namespace

Circle smallest_enclosing_circle(std::vector<Vec2> points) {
  // The same numbers each time, and everywhere: std::shuffle's use of them would not be.
  std::minstd_rand order(kShuffleSeed);  // NOLINT(bugprone-random-generator-seed)
  for (std::size_t k = points.size(); k > 1; --k) std::swap(points[k - 1], points[order() % k]);
  Circle circle;
  for (std::size_t k = 0; k < points.size(); ++k) {
    if (k == 0 || !holds(circle, points[k])) {
      circle = round_with(std::span(points).first(k), points[k]);
    }
  }
  return circle;
}

}  // namespace pdg
