#include "scene.hpp"

#include <algorithm>
#include <limits>

namespace planner {

Polygon PolygonSet::polygon(const std::size_t index) const {
  Polygon out;
  for (std::uint32_t r = polygon_starts[index]; r < polygon_starts[index + 1]; ++r)
    out.rings.emplace_back(points.begin() + ring_starts[r], points.begin() + ring_starts[r + 1]);
  return out;
}

Rectangle PolygonSet::bounds(const std::size_t index) const {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  Rectangle box{{kInfinity, kInfinity}, {-kInfinity, -kInfinity}};
  const std::uint32_t outer = polygon_starts[index];  // holes lie inside
  for (std::uint32_t i = ring_starts[outer]; i < ring_starts[outer + 1]; ++i) {
    const Vec2 p = points[i];
    box.low = {std::min(box.low.x, p.x), std::min(box.low.y, p.y)};
    box.high = {std::max(box.high.x, p.x), std::max(box.high.y, p.y)};
  }
  return box;
}

void PolygonSet::append(const Polygon& polygon) {
  for (const pdg::Ring& ring : polygon.rings) {
    points.insert(points.end(), ring.begin(), ring.end());
    ring_starts.push_back(static_cast<std::uint32_t>(points.size()));
  }
  polygon_starts.push_back(static_cast<std::uint32_t>(ring_starts.size() - 1));
}

}  // namespace planner
