#include "convex_hull.hpp"

#include <algorithm>
#include <cstddef>

#include "predicates.hpp"

namespace pdg {

// Andrew's monotone chain: lower hull from left to right, upper hull back.
ConvexPolygon convex_hull(std::vector<Vec2> points) {
  std::sort(points.begin(), points.end(), lexicographically_less);
  points.erase(std::unique(points.begin(), points.end()), points.end());
  if (points.size() < 3) return points;
  ConvexPolygon hull;
  const auto extend = [&hull](const Vec2 p, const std::size_t keep) {
    while (hull.size() >= keep + 2 && orient2d(hull[hull.size() - 2], hull.back(), p) <= 0) {
      hull.pop_back();
    }
    hull.push_back(p);
  };
  for (const Vec2 p : points) extend(p, 0);
  const std::size_t lower = hull.size() - 1;
  for (auto p = points.rbegin() + 1; p != points.rend(); ++p) extend(*p, lower);
  hull.pop_back();
  return hull;
}

ConvexPolygon convex_hull(const std::vector<ConvexPolygon>& polygons) {
  std::vector<Vec2> points;
  for (const ConvexPolygon& polygon : polygons) {
    points.insert(points.end(), polygon.begin(), polygon.end());
  }
  return convex_hull(std::move(points));
}

}  // namespace pdg
