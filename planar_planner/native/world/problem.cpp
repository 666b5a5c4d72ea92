#include "problem.hpp"

#include <algorithm>
#include <limits>

namespace planner {

Polygon PolygonSet::polygon(const std::size_t index) const {
  Polygon out;
  for (std::uint32_t r = polygon_starts[index]; r < polygon_starts[index + 1]; ++r)
    out.rings.emplace_back(points.begin() + ring_starts[r], points.begin() + ring_starts[r + 1]);
  return out;
}

std::span<const Vec2> PolygonSet::outer_ring(const std::size_t index) const {
  const std::uint32_t outer = polygon_starts[index];
  return std::span(points).subspan(ring_starts[outer], ring_starts[outer + 1] - ring_starts[outer]);
}

Rectangle PolygonSet::bounds(const std::size_t index) const {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  Rectangle box{{kInfinity, kInfinity}, {-kInfinity, -kInfinity}};
  for (const Vec2 p : outer_ring(index)) {  // holes lie inside
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
