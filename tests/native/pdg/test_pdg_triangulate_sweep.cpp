// The sweep against integer areas: its triangles tile the interior, or it declines.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <utility>

#include "integer_oracle.hpp"
#include "pdg/native/triangulation/triangulate_sweep.hpp"
#include "random_polygons.hpp"

namespace {

using pdg::Index;
using pdg::PointMesh;
using pdg::Polygon;
using pdg::Ring;
using pdg::Vec2;

std::size_t vertex_count(const Polygon& polygon) {
  std::size_t count = 0;
  for (const Ring& ring : polygon.rings) count += ring.size();
  return count;
}

bool is_edge(const Polygon& polygon, const Vec2 a, const Vec2 b) {
  return std::any_of(polygon.rings.begin(), polygon.rings.end(), [&](const Ring& ring) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Vec2 p = ring[i];
      const Vec2 q = ring[(i + 1) % ring.size()];
      if ((p == a && q == b) || (p == b && q == a)) return true;
    }
    return false;
  });
}

// Counter-clockwise triangles that are glued edge to edge, whose rim is the polygon and whose areas
// add up to its area.
void expect_tiling(const fuzz::Sample& sample, const PointMesh& mesh) {
  std::int64_t twice_area = 0;
  std::size_t rim = 0;
  for (Index h = 0; h < 3 * mesh.triangle_count(); ++h) {
    const Vec2 a = mesh.point(mesh.from(h));
    const Vec2 b = mesh.point(mesh.to(h));
    if (h % 3 == 0) {
      const std::int64_t area = oracle::side(oracle::integer(a), oracle::integer(b),
                                             oracle::integer(mesh.point(mesh.to(h + 1))));
      EXPECT_GT(area, 0);
      twice_area += area;
    }
    if (mesh.opposite(h) == pdg::kNone) {
      ++rim;
      EXPECT_EQ(mesh.odd[static_cast<std::size_t>(h)], 1);
      EXPECT_TRUE(is_edge(sample.polygon, a, b));
    } else {
      EXPECT_EQ(mesh.opposite(mesh.opposite(h)), h);
      EXPECT_EQ(mesh.from(mesh.opposite(h)), mesh.to(h));
      EXPECT_EQ(mesh.to(mesh.opposite(h)), mesh.from(h));
    }
  }
  EXPECT_EQ(twice_area, sample.twice_area);
  EXPECT_EQ(rim, vertex_count(sample.polygon));
}

std::int64_t twice_area(const Ring& ring) {
  double area = 0.0;  // exact: integers
  for (std::size_t i = 0; i < ring.size(); ++i)
    area += pdg::cross(ring[i], ring[(i + 1) % ring.size()]);
  return static_cast<std::int64_t>(std::abs(area));
}

// A star-shaped ring about a point, with every second vertex drawn in.
Ring star(const Vec2 centre, const int points, const double outer, const double inner) {
  Ring ring;
  for (int i = 0; i < points; ++i) {
    const double angle = 2.0 * std::numbers::pi * (i + 0.1) / points;
    const double radius = i % 2 == 0 ? outer : inner;
    ring.push_back({std::round(centre.x + radius * std::cos(angle)),
                    std::round(centre.y + radius * std::sin(angle))});
  }
  return ring;
}

TEST(TriangulateSweep, TilesRandomSimplePolygons) {
  fuzz::Random random(41);
  int swept = 0;
  for (int round = 0; round < 3000; ++round) {
    fuzz::Sample sample = fuzz::random_simple(random, fuzz::pick(random, 3, 24), 1000);
    if (round % 2 == 0)
      std::reverse(sample.polygon.rings[0].begin(), sample.polygon.rings[0].end());
    const auto mesh = pdg::triangulate_sweep(sample.polygon);
    if (!mesh) continue;
    ++swept;
    EXPECT_EQ(static_cast<std::size_t>(mesh->triangle_count()), sample.polygon.rings[0].size() - 2);
    expect_tiling(sample, *mesh);
  }
  EXPECT_GT(swept, 2900);
}

// Vertical edges, collinear vertices, holes, rings that touch: whatever it accepts is a tiling.
TEST(TriangulateSweep, TilesCellsThatDoNotTouch) {
  fuzz::Random random(42);
  int swept = 0;
  int declined = 0;
  for (int round = 0; round < 4000; ++round) {
    const fuzz::Sample sample =
        fuzz::random_cells(random, fuzz::pick(random, 2, 6), round % 2 == 0 ? 0.0 : 1.0);
    if (sample.polygon.rings.empty()) continue;
    const auto mesh = pdg::triangulate_sweep(sample.polygon);
    mesh ? ++swept : ++declined;
    if (mesh) expect_tiling(sample, *mesh);
  }
  EXPECT_GT(swept, 400);
  EXPECT_GT(declined, 400);
}

TEST(TriangulateSweep, TilesAPolygonWithHoles) {
  fuzz::Sample sample;
  sample.polygon.rings = {star({0, 0}, 60, 100'000, 80'000), star({-30'000, 0}, 40, 20'000, 9'000),
                          star({30'000, 500}, 31, 20'000, 19'000)};
  sample.twice_area = twice_area(sample.polygon.rings[0]) - twice_area(sample.polygon.rings[1]) -
                      twice_area(sample.polygon.rings[2]);
  const auto mesh = pdg::triangulate_sweep(sample.polygon);
  ASSERT_TRUE(mesh);
  EXPECT_EQ(static_cast<std::size_t>(mesh->triangle_count()),
            vertex_count(sample.polygon) - 2 + 2 * 2);
  expect_tiling(sample, *mesh);
}

TEST(TriangulateSweep, DeclinesWhatIsNotSimple) {
  const auto declines = [](std::vector<Ring> rings) {
    return !pdg::triangulate_sweep(Polygon{std::move(rings)});
  };
  const Ring square{{0, 0}, {8, 0}, {8, 8}, {0, 8}};
  EXPECT_FALSE(declines({square}));
  EXPECT_TRUE(declines({{{0, 0}, {8, 8}, {8, 0}, {0, 8}}}));                          // bow tie
  EXPECT_TRUE(declines({{{0, 0}, {8, 0}, {8, 8}, {4, 0}, {0, 8}}}));                  // on an edge
  EXPECT_TRUE(declines({{{0, 0}, {4, 0}, {4, 4}, {8, 4}, {8, 8}, {4, 8}, {4, 4}}}));  // twice
  EXPECT_TRUE(declines({{{0, 0}, {8, 0}, {4, 0}, {4, 4}}}));                          // spike
  EXPECT_TRUE(declines({square, {{8, 2}, {12, 2}, {12, 4}}}));                        // touches
  EXPECT_TRUE(declines({square, {{6, 2}, {12, 2}, {12, 4}}}));                        // crosses
  EXPECT_TRUE(declines({square, square}));
  EXPECT_TRUE(declines({{{0, 0}, {8, 0}, {8, 8}, {0, 8}, {0, 8}}}));
  EXPECT_TRUE(declines({{{0, 0}, {1e300, 0}, {8, 8}}}));
}

// A ring that winds twice round its middle and crosses itself once.
TEST(TriangulateSweep, DeclinesAPolygonThatOverlapsItself) {
  const Ring ring{{-10, -10}, {10, -10}, {10, 10},  {-10, 10},  {-10, -4},
                  {14, -4},   {14, 14},  {-14, 14}, {-14, -14}, {-12, -14}};
  EXPECT_FALSE(pdg::triangulate_sweep(Polygon{{ring}}));
}

}  // namespace
