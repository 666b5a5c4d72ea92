#include "ring_sweep.hpp"

#include <algorithm>
#include <numeric>

namespace pdg {

SweepVertices sort_vertices(const Polygon& polygon) {
  std::vector<Vec2> given;
  std::vector<Index> starts{0};
  for (const Ring& ring : polygon.rings) {
    for (const Vec2 p : ring) {
      if (!in_exact_range(p)) return {};
      given.push_back({p.x + 0.0, p.y + 0.0});  // -0 and 0 are the same point
    }
    starts.push_back(static_cast<Index>(given.size()));
  }
  const std::size_t n = given.size();
  std::vector<Index> order(n);
  std::iota(order.begin(), order.end(), Index{0});
  const auto at = [](const Index i) { return static_cast<std::size_t>(i); };
  std::sort(order.begin(), order.end(), [&](const Index a, const Index b) {
    return lexicographically_less(given[at(a)], given[at(b)]);
  });
  SweepVertices sorted;
  std::vector<Index> rank(n);
  sorted.points.reserve(n);
  for (std::size_t i = 0; i < n; ++i) {
    rank[at(order[i])] = static_cast<Index>(i);
    sorted.points.push_back(given[at(order[i])]);
    if (i > 0 && !lexicographically_less(sorted.points[i - 1], sorted.points[i])) return {};
  }
  sorted.neighbours.resize(n);
  sorted.rings.resize(n);
  for (std::size_t r = 0; r + 1 < starts.size(); ++r) {
    for (Index i = starts[r]; i < starts[r + 1]; ++i) {
      const Index next = i + 1 < starts[r + 1] ? i + 1 : starts[r];
      sorted.neighbours[at(rank[at(i)])][1] = rank[at(next)];
      sorted.neighbours[at(rank[at(next)])][0] = rank[at(i)];
      sorted.rings[at(rank[at(i)])] = static_cast<Index>(r);
    }
  }
  return sorted;
}

}  // namespace pdg
