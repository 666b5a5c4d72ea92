#include "enclosing_circle.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <span>

#include "pdg/native/tolerances.hpp"

namespace pdg {
namespace {

double power(const WeightedPoint& a, const Vec2 c) {
  const Vec2 d = a.p - c;
  return dot(d, d) + a.weight;
}

WeightedCentre centre_of(const WeightedPoint& a) {
  return {a.p, 1, {a}, {1.0}};
}

// The least of the greater power of two points lies between them, where the powers are equal, or at
// the one that outweighs the other everywhere on the way.
WeightedCentre centre_of(const WeightedPoint& a, const WeightedPoint& b) {
  const Vec2 along = b.p - a.p;
  const double square = dot(along, along);
  if (square == 0.0) return centre_of(a.weight >= b.weight ? a : b);
  const double share = std::clamp(0.5 + 0.5 * (b.weight - a.weight) / square, 0.0, 1.0);
  return {a.p + share * along, 2, {a, b}, {1.0 - share, share}};
}

// The point of equal power of three points, if it lies among them.
std::optional<WeightedCentre> centre_of(const WeightedPoint& a, const WeightedPoint& b,
                                        const WeightedPoint& c) {
  const Vec2 u = b.p - a.p;
  const Vec2 v = c.p - a.p;
  const double area = cross(u, v);
  const double pu = 0.5 * (dot(u, u) + b.weight - a.weight);
  const double pv = 0.5 * (dot(v, v) + c.weight - a.weight);
  const Vec2 x{(pu * v.y - pv * u.y) / area, (pv * u.x - pu * v.x) / area};
  const double of_b = cross(x, v) / area;
  const double of_c = cross(u, x) / area;
  if (!(of_b >= 0.0 && of_c >= 0.0 && of_b + of_c <= 1.0)) return std::nullopt;  // nor for NaN
  return WeightedCentre{a.p + x, 3, {a, b, c}, {1.0 - of_b - of_c, of_b, of_c}};
}

std::vector<WeightedPoint> without_weights(const std::vector<Vec2>& points) {
  std::vector<WeightedPoint> result;
  result.reserve(points.size());
  for (const Vec2 p : points) result.push_back({p, 0.0});
  return result;
}

double farthest_from(const Vec2 c, const std::vector<Vec2>& points) {
  double most = 0.0;
  for (const Vec2 p : points) most = std::max(most, norm(p - c));
  return most;
}

double greatest_power(const std::span<const WeightedPoint> points, const Vec2 c) {
  double most = 0.0;
  for (const WeightedPoint& p : points) most = std::max(most, power(p, c));
  return most;
}

// The best centre of at most four points: that of some one, two or three of them.
WeightedCentre centre_of_few(const std::span<const WeightedPoint> points) {
  WeightedCentre best;
  double least = std::numeric_limits<double>::infinity();
  const auto offer = [&](const WeightedCentre& candidate) {
    const double value = greatest_power(points, candidate.c);
    if (value < least) least = value, best = candidate;
  };
  for (std::size_t i = 0; i < points.size(); ++i) {
    offer(centre_of(points[i]));
    for (std::size_t j = i + 1; j < points.size(); ++j) {
      offer(centre_of(points[i], points[j]));
      for (std::size_t k = j + 1; k < points.size(); ++k)
        if (const auto three = centre_of(points[i], points[j], points[k])) offer(*three);
    }
  }
  return best;
}

}  // namespace

// Takes in the point of greatest power until none exceeds the support's: the value grows with every
// step, and no support comes back.
WeightedCentre weighted_centre(const std::vector<WeightedPoint>& points) {
  WeightedCentre best = centre_of(points.front());
  double value = power(best.support[0], best.c);
  for (;;) {
    const auto farthest = std::max_element(points.begin(), points.end(),
                                           [&](const WeightedPoint& a, const WeightedPoint& b) {
                                             return power(a, best.c) < power(b, best.c);
                                           });
    if (power(*farthest, best.c) <= value * kRadiusPadding) return best;
    std::array<WeightedPoint, 4> few = {*farthest};
    const auto size = static_cast<std::size_t>(best.support_size);
    std::copy_n(best.support.begin(), size, few.begin() + 1);
    const std::span<const WeightedPoint> tried(few.data(), size + 1);
    const WeightedCentre next = centre_of_few(tried);
    const double grown = greatest_power(tried, next.c);
    if (grown <= value) return best;  // by rounding only
    best = next;
    value = grown;
  }
}

double radius_from_below(const WeightedCentre& centre) {
  double sum = 0.0;
  double square = 0.0;
  for (int i = 0; i < centre.support_size; ++i) {
    const auto a = static_cast<std::size_t>(i);
    sum += centre.shares[a];
    for (int j = 0; j < i; ++j) {
      const auto b = static_cast<std::size_t>(j);
      const Vec2 d = centre.support[a].p - centre.support[b].p;
      square += centre.shares[a] * centre.shares[b] * dot(d, d);
    }
  }
  return std::sqrt(square) / sum / kRadiusPadding;
}

Circle smallest_enclosing_circle(const std::vector<Vec2>& points) {
  const Vec2 centre = weighted_centre(without_weights(points)).c;
  return {centre, farthest_from(centre, points)};
}

CircleBounds enclosing_circle_bounds(const std::vector<Vec2>& points) {
  const WeightedCentre centre = weighted_centre(without_weights(points));
  return {centre.c, radius_from_below(centre), farthest_from(centre.c, points) * kRadiusPadding};
}

}  // namespace pdg
