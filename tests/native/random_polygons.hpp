// Random polygons on integer coordinates for the fuzz tests.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <random>
#include <utility>
#include <vector>

#include "pdg/native/geometry/polygon.hpp"

namespace fuzz {

using Random = std::mt19937_64;

inline int pick(Random& random, const int low, const int high) {
  return std::uniform_int_distribution<int>(low, high)(random);
}

struct Sample {
  pdg::Polygon polygon;
  std::int64_t twice_area;  // by the even-odd rule
};

// The integer matrix with rows (a, b), (c, d) applied to every vertex.
inline void transform(Sample& sample, const int a, const int b, const int c, const int d) {
  for (pdg::Ring& ring : sample.polygon.rings) {
    for (pdg::Vec2& p : ring) p = {a * p.x + b * p.y, c * p.x + d * p.y};
  }
  sample.twice_area *= std::abs(a * d - b * c);
}

// Boundary of a random set of unit cells, sheared: collinear vertices, holes, several rings that
// touch at vertices. `keep_collinear` is the share of collinear vertices left in the rings, so that
// a vertex of one ring may lie inside an edge of another.
inline Sample random_cells(Random& random, const int size, const double keep_collinear) {
  std::vector<std::vector<bool>> cell(static_cast<std::size_t>(size + 2),
                                      std::vector<bool>(static_cast<std::size_t>(size + 2)));
  const double density = std::uniform_real_distribution<double>(0.2, 0.9)(random);
  const auto filled = [&](const int x, const int y) {
    return cell[static_cast<std::size_t>(x + 1)][static_cast<std::size_t>(y + 1)];
  };
  Sample sample{{}, 0};
  for (int x = 0; x < size; ++x) {
    for (int y = 0; y < size; ++y) {
      const bool on = std::bernoulli_distribution(density)(random);
      cell[static_cast<std::size_t>(x + 1)][static_cast<std::size_t>(y + 1)] = on;
      sample.twice_area += on ? 2 : 0;
    }
  }
  using Node = std::pair<int, int>;
  std::multimap<Node, Node> edges;  // interior on the left
  for (int x = 0; x < size; ++x) {
    for (int y = 0; y < size; ++y) {
      if (!filled(x, y)) continue;
      if (!filled(x, y - 1)) edges.emplace(Node{x, y}, Node{x + 1, y});
      if (!filled(x + 1, y)) edges.emplace(Node{x + 1, y}, Node{x + 1, y + 1});
      if (!filled(x, y + 1)) edges.emplace(Node{x + 1, y + 1}, Node{x, y + 1});
      if (!filled(x - 1, y)) edges.emplace(Node{x, y + 1}, Node{x, y});
    }
  }
  while (!edges.empty()) {
    std::vector<Node> loop;
    const Node start = edges.begin()->first;
    Node node = start;
    do {
      auto [first, last] = edges.equal_range(node);
      if (std::next(first) != last && pick(random, 0, 1) == 1) ++first;
      loop.push_back(node);
      node = first->second;
      edges.erase(first);
    } while (node != start);
    pdg::Ring ring;
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const Node p = loop[(i + loop.size() - 1) % loop.size()];
      const Node q = loop[(i + 1) % loop.size()];
      const bool straight = p.first == q.first || p.second == q.second;
      if (!straight || std::bernoulli_distribution(keep_collinear)(random)) {
        ring.push_back({static_cast<double>(loop[i].first), static_cast<double>(loop[i].second)});
      }
    }
    if (pick(random, 0, 1) == 1) std::reverse(ring.begin(), ring.end());
    sample.polygon.rings.push_back(std::move(ring));
  }
  return sample;
}

// A simple polygon through random points of a small grid, untangled by 2-opt moves; retried until
// simple. Many collinear triples when the grid is small.
inline Sample random_simple(Random& random, const int vertices, const int grid) {
  const auto cross = [](const pdg::Vec2 a, const pdg::Vec2 b, const pdg::Vec2 c) {
    return pdg::cross(b - a, c - a);  // exact: small integers
  };
  const auto on_segment = [&](const pdg::Vec2 a, const pdg::Vec2 b, const pdg::Vec2 c) {
    return cross(a, b, c) == 0 && pdg::dot(a - c, b - c) <= 0;
  };
  const auto meet = [&](const pdg::Vec2 a, const pdg::Vec2 b, const pdg::Vec2 c,
                        const pdg::Vec2 d) {
    const auto sign = [](const double v) { return (v > 0) - (v < 0); };
    if (sign(cross(a, b, c)) * sign(cross(a, b, d)) < 0 &&
        sign(cross(c, d, a)) * sign(cross(c, d, b)) < 0) {
      return true;
    }
    return on_segment(a, b, c) || on_segment(a, b, d) || on_segment(c, d, a) || on_segment(c, d, b);
  };
  for (;;) {
    std::vector<pdg::Vec2> ring;
    while (static_cast<int>(ring.size()) < vertices) {
      const pdg::Vec2 p{static_cast<double>(pick(random, -grid, grid)),
                        static_cast<double>(pick(random, -grid, grid))};
      if (std::find(ring.begin(), ring.end(), p) == ring.end()) ring.push_back(p);
    }
    const std::size_t n = ring.size();
    bool simple = false;
    for (int round = 0; round < 200 && !simple; ++round) {
      simple = true;
      for (std::size_t i = 0; i < n; ++i) {
        for (std::size_t j = i + 2; j < n; ++j) {
          if (i == 0 && j == n - 1) continue;
          if (!meet(ring[i], ring[i + 1], ring[j], ring[(j + 1) % n])) continue;
          std::reverse(ring.begin() + static_cast<std::ptrdiff_t>(i) + 1,
                       ring.begin() + static_cast<std::ptrdiff_t>(j) + 1);
          simple = false;
        }
      }
    }
    // Neighbouring edges may fold back on each other.
    for (std::size_t i = 0; i < n && simple; ++i) {
      const pdg::Vec2 p = ring[(i + n - 1) % n];
      const pdg::Vec2 q = ring[(i + 1) % n];
      if (cross(p, ring[i], q) == 0 && pdg::dot(p - ring[i], q - ring[i]) > 0) simple = false;
    }
    if (!simple) continue;
    double area = 0.0;
    for (std::size_t i = 0; i < n; ++i) area += pdg::cross(ring[i], ring[(i + 1) % n]);
    return {{{std::move(ring)}}, static_cast<std::int64_t>(std::abs(area))};
  }
}

}  // namespace fuzz
