#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>
#include <vector>

#include "integer_oracle.hpp"
#include "pdg/native/geometry/predicates.hpp"
#include "pdg/native/triangulation/insertion_order.hpp"
#include "pdg/native/triangulation/triangulate_points.hpp"
#include "random_polygons.hpp"

namespace {

using pdg::Index;
using pdg::PointMesh;
using pdg::Vec2;

constexpr std::size_t kMany = 3000;  // more than are added from left to right

std::vector<Vec2> sorted(std::vector<Vec2> points) {
  std::sort(points.begin(), points.end(), pdg::lexicographically_less);
  points.erase(std::unique(points.begin(), points.end()), points.end());
  return points;
}

// Twice the area of the convex hull, and how many of the points lie on its boundary; monotone
// chain.
std::pair<std::int64_t, std::size_t> hull(const std::vector<Vec2>& points) {
  std::vector<Vec2> strict;
  for (const int pass : {0, 1}) {
    const std::size_t begin = strict.size();
    for (std::size_t k = 0; k < points.size(); ++k) {
      const Vec2 p = pass == 0 ? points[k] : points[points.size() - 1 - k];
      while (strict.size() >= begin + 2 &&
             oracle::side(oracle::integer(strict[strict.size() - 2]),
                          oracle::integer(strict.back()), oracle::integer(p)) <= 0) {
        strict.pop_back();
      }
      strict.push_back(p);
    }
    strict.pop_back();
  }
  std::size_t on_boundary = 0;
  for (const Vec2 p : points) {
    for (std::size_t i = 0; i < strict.size(); ++i) {
      if (oracle::side(oracle::integer(strict[i]), oracle::integer(strict[(i + 1) % strict.size()]),
                       oracle::integer(p)) == 0) {
        ++on_boundary;
        break;
      }
    }
  }
  return {oracle::twice_signed_area(strict), on_boundary};
}

// Positive triangles whose areas add up to the hull's, each edge once in each direction or on the
// hull, every point a vertex: a triangulation.
void expect_triangulation(const PointMesh& mesh) {
  const auto [area, on_boundary] = hull(mesh.points);
  std::int64_t sum = 0;
  std::set<Index> used;
  std::set<std::pair<Index, Index>> edges;
  for (Index t = 0; t < mesh.triangle_count(); ++t) {
    const std::vector<Vec2> triangle = {mesh.point(mesh.from(3 * t)),
                                        mesh.point(mesh.from(3 * t + 1)),
                                        mesh.point(mesh.from(3 * t + 2))};
    const std::int64_t twice = oracle::twice_signed_area(triangle);
    EXPECT_GT(twice, 0);
    sum += twice;
    for (Index h = 3 * t; h < 3 * t + 3; ++h) {
      used.insert(mesh.from(h));
      EXPECT_TRUE(edges.emplace(mesh.from(h), mesh.to(h)).second);
      const Index twin = mesh.opposite(h);
      if (twin == pdg::kNone) {
        EXPECT_EQ(mesh.hull_edge[PointMesh::at(mesh.from(h))], h);
        continue;
      }
      EXPECT_EQ(mesh.opposite(twin), h);
      EXPECT_EQ(mesh.from(twin), mesh.to(h));
      EXPECT_EQ(mesh.to(twin), mesh.from(h));
    }
  }
  EXPECT_EQ(sum, area);
  EXPECT_EQ(used.size(), mesh.points.size());
  EXPECT_EQ(PointMesh::at(mesh.triangle_count()), 2 * mesh.points.size() - 2 - on_boundary);
  for (const Index v : used) EXPECT_EQ(mesh.from(mesh.outgoing[PointMesh::at(v)]), v);
}

TEST(TriangulatePoints, EveryPointIsInsertedOnce) {
  const std::vector<Vec2> points(kMany);
  std::vector<Index> order = pdg::insertion_order(points, 7);
  EXPECT_EQ(order, pdg::insertion_order(points, 7));
  std::sort(order.begin(), order.end());
  ASSERT_EQ(order.size(), kMany - 7);
  for (std::size_t i = 0; i < order.size(); ++i) EXPECT_EQ(order[i], static_cast<Index>(i + 7));
}

TEST(TriangulatePoints, FullGrid) {  // every point on many lines of others
  std::vector<Vec2> points;
  for (int x = 0; x < 60; ++x)
    for (int y = 0; y < 60; ++y) points.push_back({1.0 * x, 1.0 * y});
  expect_triangulation(pdg::triangulate_points(sorted(points)));
}

TEST(TriangulatePoints, Fuzz) {
  fuzz::Random random(11);
  for (int k = 0; k < 12; ++k) {
    SCOPED_TRACE(k);
    std::vector<Vec2> points;
    const int size = k % 3 == 0 ? 80 : 1'000'000;
    for (std::size_t i = 0; i < kMany + 100; ++i) {
      const int x = fuzz::pick(random, 0, size);
      const int y = k % 4 == 1 ? x / 7 : fuzz::pick(random, 0, size);  // nearly on a line
      points.push_back({1.0 * x, 1.0 * (y - (k % 4 == 2 ? x : 0))});
    }
    points = sorted(points);
    if (points.size() < kMany / 2) continue;
    expect_triangulation(pdg::triangulate_points(points));
    if (HasFailure()) break;
  }
}

TEST(TriangulatePoints, FewPointsOffALine) {
  std::vector<Vec2> points;
  for (std::size_t i = 0; i < kMany; ++i) points.push_back({1.0 * static_cast<double>(i), 0.0});
  EXPECT_EQ(pdg::triangulate_points(points).triangle_count(), 0);
  points.push_back({1500.0, 7.0});
  points.push_back({1500.0, -7.0});
  points.push_back({1e6, 0.0});
  expect_triangulation(pdg::triangulate_points(sorted(points)));
}

// Two columns: added from left to right, every point of the second would flip half of the first.
TEST(TriangulatePoints, TwoColumnsTakeNoQuadraticTime) {
  constexpr int kRows = 100'000;
  std::vector<Vec2> points;
  for (int y = 0; y < kRows; ++y) points.push_back({y % 2 == 0 ? 0.0 : 1000.0, 1.0 * y});
  const PointMesh mesh = pdg::triangulate_points(sorted(points));  // quadratic: 10^10 flips
  EXPECT_EQ(mesh.triangle_count(), kRows - 2);
}

}  // namespace
