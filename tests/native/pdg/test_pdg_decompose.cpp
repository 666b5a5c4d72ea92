#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "integer_oracle.hpp"
#include "pdg/native/pieces/decompose.hpp"
#include "pdg/native/triangulation/triangulate.hpp"
#include "random_polygons.hpp"

namespace {

using pdg::ConvexPolygon;
using pdg::Polygon;
using pdg::Ring;
using pdg::Vec2;

bool is_input_vertex(const Polygon& polygon, const Vec2 v) {
  return std::any_of(polygon.rings.begin(), polygon.rings.end(), [&](const Ring& ring) {
    return std::find(ring.begin(), ring.end(), v) != ring.end();
  });
}

bool contains(const ConvexPolygon& outer, const ConvexPolygon& inner) {
  for (std::size_t i = 0; i < outer.size(); ++i) {
    for (const Vec2 v : inner) {
      if (oracle::side(oracle::integer(outer[i]), oracle::integer(outer[(i + 1) % outer.size()]),
                       oracle::integer(v)) < 0) {
        return false;
      }
    }
  }
  return true;
}

void expect_valid_pieces(const fuzz::Sample& sample, const std::vector<ConvexPolygon>& pieces) {
  for (const ConvexPolygon& piece : pieces) {
    EXPECT_TRUE(oracle::strictly_convex(piece));
    EXPECT_TRUE(oracle::inside(sample.polygon, piece));
    for (const Vec2 v : piece) EXPECT_TRUE(is_input_vertex(sample.polygon, v));
  }
}

// Pieces inside the polygon whose areas add up to its area tile it: an overlap or a gap would show.
void expect_partition(const fuzz::Sample& sample, const std::vector<ConvexPolygon>& pieces) {
  std::int64_t area = 0;
  for (const ConvexPolygon& piece : pieces) area += oracle::twice_signed_area(piece);
  EXPECT_EQ(area, sample.twice_area);
  expect_valid_pieces(sample, pieces);
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      for (std::size_t k = 0; k < pieces[j].size(); ++k) {
        EXPECT_FALSE(oracle::meets_interior(oracle::integer(pieces[j][k]),
                                            oracle::integer(pieces[j][(k + 1) % pieces[j].size()]),
                                            pieces[i]));
      }
    }
  }
}

void expect_all(const fuzz::Sample& sample) {
  const pdg::Triangulation triangulation = pdg::triangulate(sample.polygon);
  std::vector<ConvexPolygon> triangles;
  for (const auto& t : triangulation.triangles) {
    ConvexPolygon triangle;
    for (const pdg::Index v : t) triangle.push_back(triangulation.points[static_cast<size_t>(v)]);
    triangles.push_back(triangle);
  }
  expect_partition(sample, triangles);
  const std::vector<ConvexPolygon> partition = pdg::convex_partition(sample.polygon);
  expect_partition(sample, partition);
  const std::vector<ConvexPolygon> cover = pdg::convex_pieces(sample.polygon);
  expect_valid_pieces(sample, cover);
  EXPECT_LE(cover.size(), partition.size());
  for (const ConvexPolygon& part : partition) {
    EXPECT_TRUE(std::any_of(cover.begin(), cover.end(),
                            [&](const ConvexPolygon& piece) { return contains(piece, part); }));
  }
}

TEST(Decompose, FuzzCellBoundaries) {
  fuzz::Random random(3);
  for (int k = 0; k < 400; ++k) {
    SCOPED_TRACE(k);
    fuzz::Sample sample = fuzz::random_cells(random, 2 + k % 6, (k % 5) / 4.0);
    if (sample.twice_area == 0) continue;
    fuzz::transform(sample, 3, fuzz::pick(random, -2, 2), fuzz::pick(random, -1, 1), 2);
    expect_all(sample);
    if (HasFailure()) break;
  }
}

TEST(Decompose, FuzzSimplePolygons) {
  fuzz::Random random(4);
  for (int k = 0; k < 400; ++k) {
    SCOPED_TRACE(k);
    const int grid = k % 2 == 0 ? 4 : 1000;
    expect_all(fuzz::random_simple(random, fuzz::pick(random, 3, 24), grid));
    if (HasFailure()) break;
  }
}

// Slivers: a long thin shear makes nearly every triangle flat.
TEST(Decompose, FuzzSlivers) {
  fuzz::Random random(5);
  for (int k = 0; k < 200; ++k) {
    SCOPED_TRACE(k);
    fuzz::Sample sample = fuzz::random_simple(random, fuzz::pick(random, 4, 16), 9);
    fuzz::transform(sample, 9973, 9967, 9949, 9943);
    expect_all(sample);
    if (HasFailure()) break;
  }
}

TEST(Decompose, ConvexPolygonIsItsOwnPiece) {
  const Ring clockwise = {{0, 0}, {0, 2}, {0, 4}, {4, 4}, {4, 0}, {2, 0}, {1, 0}};
  const std::vector<ConvexPolygon> pieces = pdg::convex_pieces({{clockwise}});
  ASSERT_EQ(pieces.size(), 1U);
  EXPECT_EQ(pieces[0].size(), 4U);
  EXPECT_EQ(oracle::twice_signed_area(pieces[0]), 32);
}

// A pentagram turns only one way, but twice round: by the even-odd rule its core is a hole. Its
// edges cross at no vertex.
TEST(Decompose, RejectsCrossingEdges) {
  const Ring pentagram = {{0, 10}, {6, -8}, {-10, 3}, {10, 3}, {-6, -8}};
  EXPECT_TRUE(pdg::as_convex(pentagram).empty());
  EXPECT_THROW(pdg::convex_pieces({{pentagram}}), std::invalid_argument);
}

TEST(Decompose, RejectsBadRings) {
  EXPECT_THROW(pdg::convex_pieces({{{{0, 0}, {1, 0}}}}), std::invalid_argument);
  EXPECT_THROW(pdg::convex_pieces({}), std::invalid_argument);
  EXPECT_THROW(pdg::convex_pieces({{{{0, 0}, {1, 0}, {NAN, 1}}}}), std::invalid_argument);
  EXPECT_TRUE(pdg::convex_pieces({{{{0, 0}, {1, 1}, {2, 2}}}}).empty());
}

// Hole that touches the outer ring in a vertex, in the interior of an edge, and another hole.
TEST(Decompose, TouchingHoles) {
  const Ring outer = {{0, 0}, {12, 0}, {12, 12}, {0, 12}};
  const Ring corner = {{0, 0}, {4, 1}, {4, 4}};
  const Ring on_edge = {{6, 12}, {8, 8}, {4, 4}};  // touches the outer edge and the other hole
  fuzz::Sample sample{{{outer, corner, on_edge}}, 2 * 144};
  sample.twice_area -= std::abs(oracle::twice_signed_area(corner));
  sample.twice_area -= std::abs(oracle::twice_signed_area(on_edge));
  expect_all(sample);
}

Ring gear(const int teeth) {
  Ring ring;
  const double step = 2.0 * std::numbers::pi / teeth;
  for (int i = 0; i < teeth; ++i) {
    const double offsets[] = {-0.3, -0.18, 0.18, 0.3};
    for (int k = 0; k < 4; ++k) {
      const double radius = k == 0 || k == 3 ? 8.0 : 10.0;
      const double angle = (i + offsets[k]) * step;
      ring.push_back({radius * std::cos(angle), radius * std::sin(angle)});
    }
  }
  return ring;
}

TEST(Decompose, GearIsOneCoreAndItsTeeth) {
  for (const int teeth : {6, 8, 16, 61, 400}) {
    const Polygon polygon{{gear(teeth)}};
    EXPECT_EQ(pdg::convex_pieces(polygon).size(), static_cast<std::size_t>(teeth) + 1);
  }
  // A tooth reaches deep into the core, not only to its base.
  for (const ConvexPolygon& piece : pdg::convex_pieces({{gear(8)}})) {
    EXPECT_GT(piece.size(), 6U);
  }
}

// Three equal diagonals meet in the reflex corner; only one of them is needed.
TEST(Decompose, FatLIsTwoPieces) {
  const Ring ring = {{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}};
  EXPECT_EQ(pdg::convex_partition({{ring}}).size(), 2U);
  EXPECT_EQ(pdg::convex_pieces({{ring}}).size(), 2U);
}

TEST(Decompose, IsDeterministicAndIndependentOfOrientationAndStart) {
  const Ring ring = gear(11);
  Ring other(ring.rbegin(), ring.rend());
  std::rotate(other.begin(), other.begin() + 7, other.end());
  const std::vector<ConvexPolygon> a = pdg::convex_pieces({{ring}});
  EXPECT_EQ(a, pdg::convex_pieces({{ring}}));
  EXPECT_EQ(a, pdg::convex_pieces({{other}}));
}

}  // namespace
