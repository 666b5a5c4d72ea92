#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <set>

#include "integer_oracle.hpp"
#include "pdg/native/depth/displacement.hpp"
#include "pdg/native/depth/generalized_depth.hpp"
#include "pdg/native/geometry/box_tree.hpp"
#include "pdg/native/geometry/predicates.hpp"
#include "pdg/native/separation/c_obstacle_query.hpp"
#include "random_polygons.hpp"

namespace {

using fuzz::pick;
using fuzz::Random;
using pdg::ConvexPolygon;
using pdg::PairState;
using pdg::Vec2;

double uniform(Random& random, const double low, const double high) {
  return std::uniform_real_distribution<double>(low, high)(random);
}

// Strictly convex hull of random points (monotone chain on exact orientations).
ConvexPolygon hull(std::vector<Vec2> points) {
  std::sort(points.begin(), points.end(), pdg::lexicographically_less);
  points.erase(std::unique(points.begin(), points.end()), points.end());
  ConvexPolygon chain;
  for (int half = 0; half < 2; ++half) {
    const std::size_t base = chain.size();
    for (const Vec2 p : points) {
      while (chain.size() >= base + 2 &&
             pdg::orient2d(chain[chain.size() - 2], chain.back(), p) <= 0)
        chain.pop_back();
      chain.push_back(p);
    }
    chain.pop_back();
    std::reverse(points.begin(), points.end());
  }
  return chain;
}

ConvexPolygon random_convex(Random& random, const int grid) {
  for (;;) {
    std::vector<Vec2> points;
    const int n = pick(random, 3, 9);
    for (int i = 0; i < n; ++i) {
      points.push_back({static_cast<double>(pick(random, -grid, grid)),
                        static_cast<double>(pick(random, -grid, grid))});
    }
    ConvexPolygon polygon = hull(points);
    if (polygon.size() >= 3) return polygon;
  }
}

// Independent of the edges' lines: convex interiors meet iff an edge of one meets the interior of
// the other or one holds the other's centroid.
bool interiors_meet(const ConvexPolygon& a, const ConvexPolygon& b) {
  const auto crosses = [](const ConvexPolygon& p, const ConvexPolygon& q) {
    for (std::size_t i = 0; i < p.size(); ++i) {
      if (oracle::meets_interior(oracle::integer(p[i]), oracle::integer(p[(i + 1) % p.size()]), q))
        return true;
    }
    return false;
  };
  return crosses(a, b) || crosses(b, a) || oracle::inside({{a}}, b) || oracle::inside({{b}}, a);
}

bool segments_meet(const Vec2 a, const Vec2 b, const Vec2 c, const Vec2 d) {
  const auto side = [](const Vec2 p, const Vec2 q, const Vec2 r) {
    const std::int64_t s = oracle::side(oracle::integer(p), oracle::integer(q), oracle::integer(r));
    return (s > 0) - (s < 0);
  };
  const auto on = [&](const Vec2 p, const Vec2 q, const Vec2 r) {
    return side(p, q, r) == 0 && pdg::dot(p - r, q - r) <= 0;
  };
  return (side(a, b, c) * side(a, b, d) < 0 && side(c, d, a) * side(c, d, b) < 0) || on(a, b, c) ||
         on(a, b, d) || on(c, d, a) || on(c, d, b);
}

PairState oracle_state(const ConvexPolygon& a, const ConvexPolygon& b) {
  if (interiors_meet(a, b)) return PairState::kOverlap;
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (std::size_t j = 0; j < b.size(); ++j) {
      if (segments_meet(a[i], a[(i + 1) % a.size()], b[j], b[(j + 1) % b.size()]))
        return PairState::kTouching;
    }
  }
  return PairState::kApart;
}

ConvexPolygon moved(ConvexPolygon polygon, const Vec2 t) {
  for (Vec2& v : polygon) v = v + t;
  return polygon;
}

TEST(TranslationalDepth, StateIsExact) {
  Random random(11);
  int seen[3] = {0, 0, 0};
  for (int k = 0; k < 20000; ++k) {
    const ConvexPolygon a = random_convex(random, 4);
    const Vec2 t{static_cast<double>(pick(random, -8, 8)),
                 static_cast<double>(pick(random, -8, 8))};
    const ConvexPolygon b = moved(random_convex(random, 4), t);
    const PairState expected = oracle_state(a, b);
    ASSERT_EQ(pdg::pair_state(a, b), expected);
    ASSERT_EQ(pdg::pair_state(b, a), expected);
    ++seen[static_cast<int>(expected)];
  }
  for (const int count : seen) EXPECT_GT(count, 500);
}

// Moving A by a little more than the answer leaves it free; when they overlap, by a little less
// does not. The witness points differ by just that move.
TEST(TranslationalDepth, MoveMakesThemTouch) {
  Random random(12);
  for (int k = 0; k < 5000; ++k) {
    const ConvexPolygon a = random_convex(random, 50);
    const Vec2 t{uniform(random, -70, 70), uniform(random, -70, 70)};
    const ConvexPolygon b = moved(random_convex(random, 50), t);
    const pdg::TranslationalDepth d = pdg::translational_depth(a, b);
    EXPECT_NEAR(pdg::norm(d.direction), 1.0, 1e-14);
    const Vec2 step = d.on_b - (d.on_a + d.depth * d.direction);
    EXPECT_LT(pdg::norm(step), 1e-12);
    constexpr double kNudge = 1e-11;  // length; coordinates are of the order of 100
    const ConvexPolygon beyond = moved(a, (d.depth + kNudge) * d.direction);
    const ConvexPolygon before = moved(a, (d.depth - kNudge) * d.direction);
    EXPECT_EQ(pdg::pair_state(beyond, b), PairState::kApart);
    if (d.state == PairState::kOverlap) {
      EXPECT_EQ(pdg::pair_state(before, b), PairState::kOverlap);
    }
    const pdg::TranslationalDepth back = pdg::translational_depth(b, a);
    EXPECT_NEAR(back.depth, d.depth, 1e-13 * 100);
  }
}

TEST(BoxTree, FindsWhatBruteForceFinds) {
  Random random(13);
  for (int k = 0; k < 200; ++k) {
    std::vector<pdg::Box> boxes;
    const int n = pick(random, 0, 60);
    const auto box = [&] {
      const Vec2 low{static_cast<double>(pick(random, 0, 30)),
                     static_cast<double>(pick(random, 0, 30))};
      return pdg::Box{low, low + Vec2{static_cast<double>(pick(random, 0, 6)),
                                      static_cast<double>(pick(random, 0, 6))}};
    };
    for (int i = 0; i < n; ++i) boxes.push_back(box());
    const pdg::BoxTree tree = pdg::build_box_tree(boxes);
    for (int m = 0; m < 20; ++m) {
      const pdg::Box query = box();
      std::vector<std::int32_t> found;
      pdg::find_meeting(tree, query, found);
      std::multiset<std::int32_t> expected;
      for (int i = 0; i < n; ++i) {
        if (pdg::boxes_meet(boxes[static_cast<std::size_t>(i)], query)) expected.insert(i);
      }
      EXPECT_EQ(std::multiset<std::int32_t>(found.begin(), found.end()), expected);
    }
  }
}

pdg::PieceSet random_body(Random& random, const int pieces, const double spread) {
  std::vector<ConvexPolygon> polygons;
  for (int i = 0; i < pieces; ++i) {
    const Vec2 t{uniform(random, -spread, spread), uniform(random, -spread, spread)};
    polygons.push_back(moved(random_convex(random, 10), t));
  }
  return pdg::make_piece_set(polygons);
}

TEST(GeneralizedDepth, IsTheMaximumOverAllPairs) {
  Random random(14);
  for (int k = 0; k < 300; ++k) {
    const pdg::PieceSet a = random_body(random, pick(random, 1, 5), 15);
    const pdg::PieceSet b = random_body(random, pick(random, 1, 12), 40);
    const pdg::Pose pose{{uniform(random, -20, 20), uniform(random, -20, 20)},
                         uniform(random, -4, 4)};
    double expected = 0.0;
    for (const ConvexPolygon& p : a.polygons) {
      for (const ConvexPolygon& q : b.polygons) {
        expected = std::max(expected, pdg::translational_depth(pdg::placed(p, pose), q).depth);
      }
    }
    const pdg::DepthLowerBound bound = pdg::generalized_depth_lower_bound(a, b, pose);
    EXPECT_EQ(bound.depth, expected);
    EXPECT_EQ(bound.piece_a >= 0, expected > 0.0);
  }
}

bool overlaps(const pdg::PieceSet& a, const pdg::PieceSet& b, const pdg::Pose& pose) {
  return pdg::generalized_depth_lower_bound(a, b, pose).piece_a >= 0;
}

pdg::Pose in_cell(Random& random, const pdg::Cell& cell) {
  const auto along = [&](const double half) {  // corners and faces often
    const int kind = pick(random, 0, 4);
    return kind == 0 ? -half : kind == 1 ? half : uniform(random, -half, half);
  };
  return {cell.centre.t + Vec2{along(cell.half.x), along(cell.half.y)},
          cell.centre.theta + along(cell.half.theta)};
}

TEST(CObstacleQuery, NeverWrongAndPerNormalDominates) {
  Random random(15);
  int proved[3] = {0, 0, 0};
  for (int k = 0; k < 3000; ++k) {
    const pdg::PieceSet a = random_body(random, pick(random, 1, 2), 5);
    const pdg::PieceSet b = random_body(random, pick(random, 1, 3), 8);
    const double size = std::exp(uniform(random, -4, 2));
    const double turn = std::exp(uniform(random, -6, 1.5));
    const pdg::Cell cell{{{uniform(random, -8, 8), uniform(random, -8, 8)}, uniform(random, -7, 7)},
                         {size * uniform(random, 0, 1), size * uniform(random, 0, 1), turn}};
    bool full[3];
    for (int m = 0; m < 3; ++m) {
      const auto verdict = pdg::c_obstacle_query(a, b, cell, static_cast<pdg::QueryMethod>(m));
      EXPECT_EQ(verdict.full, verdict.margin > 0.0);
      full[m] = verdict.full;
      proved[m] += verdict.full;
    }
    EXPECT_LE(full[0], full[1]);
    EXPECT_LE(full[1], full[2]) << k;
    if (!full[0] && !full[1] && !full[2]) continue;
    for (int s = 0; s < 60; ++s) ASSERT_TRUE(overlaps(a, b, in_cell(random, cell)));
  }
  EXPECT_GT(proved[0], 100);
  EXPECT_GT(proved[1], proved[0] + 30);
  EXPECT_GT(proved[2], proved[1] + 100);
}

// Concentric axis-parallel squares of half-side 1, h_x = h_y = 1.9: PD^t = 2 < 2.69.
TEST(CObstacleQuery, StrictExampleOfThePerNormalForm) {
  const ConvexPolygon square = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
  const pdg::PieceSet body = pdg::make_piece_set({square});
  const pdg::Cell cell{{{0, 0}, 0}, {1.9, 1.9, 0}};
  EXPECT_TRUE(pdg::c_obstacle_query(body, body, cell, pdg::QueryMethod::kPerNormal).full);
  EXPECT_FALSE(pdg::c_obstacle_query(body, body, cell, pdg::QueryMethod::kDisplacement).full);
  EXPECT_FALSE(pdg::c_obstacle_query(body, body, cell, pdg::QueryMethod::kPublished).full);
  const pdg::Cell touching{{{0, 0}, 0}, {2, 2, 0}};  // its corners only touch
  EXPECT_FALSE(pdg::c_obstacle_query(body, body, touching, pdg::QueryMethod::kPerNormal).full);
}

// A tiny body deep in a near-disc, a square of translations, all turns: the extent of the square
// along a turning normal is that of its diagonal, not the sum of its sides.
TEST(CObstacleQuery, PerNormalDominatesWithWideTurns) {
  std::vector<Vec2> circle;
  for (int i = 0; i < 64; ++i) {
    const double angle = 2 * std::numbers::pi * i / 64;
    circle.push_back({10 * std::cos(angle), 10 * std::sin(angle)});
  }
  const pdg::PieceSet disc = pdg::make_piece_set({hull(circle)});
  const pdg::PieceSet tiny = pdg::make_piece_set({{{-0.1, -0.1}, {0.1, -0.1}, {0, 0.1}}});
  for (const double turn : {0.5, 1.0, 2.0, 10.0}) {
    const pdg::Cell cell{{{0, 0}, 0.3}, {6, 6, turn}};
    EXPECT_TRUE(pdg::c_obstacle_query(tiny, disc, cell, pdg::QueryMethod::kDisplacement).full);
    EXPECT_TRUE(pdg::c_obstacle_query(tiny, disc, cell, pdg::QueryMethod::kPerNormal).full);
  }
}

TEST(MotionBounds, CoverSampledMotions) {
  Random random(16);
  for (int k = 0; k < 3000; ++k) {
    const pdg::PieceSet body = random_body(random, 1, 5);
    const pdg::Cell cell{{{uniform(random, -9, 9), uniform(random, -9, 9)}, uniform(random, -4, 4)},
                         {uniform(random, 0, 2), uniform(random, 0, 2), uniform(random, 0, 5)}};
    const double disp = pdg::displacement_bound(cell.half, body.radius);
    const double arc = pdg::arc_bound(cell.half, body.radius);
    EXPECT_LE(disp, arc);
    EXPECT_LE(arc, pdg::sum_bound(cell.half, body.radius));
    const pdg::Pose q = in_cell(random, cell);
    constexpr double kRounding = 1e-13;  // of the sampled distances, length
    EXPECT_LE(pdg::displacement(body, cell.centre, q), disp + kRounding);
    EXPECT_LE(pdg::generalized_distance_bounds(body, cell.centre, q).upper, arc + kRounding);
  }
}

TEST(Displacement, IsTheLargestOverBodyPoints) {
  Random random(17);
  for (int k = 0; k < 500; ++k) {
    const pdg::PieceSet body = random_body(random, 2, 5);
    const pdg::Pose from{{uniform(random, -9, 9), 0.0}, uniform(random, -4, 4)};
    const pdg::Pose to{{0.0, uniform(random, -9, 9)}, uniform(random, -4, 4)};
    double expected = 0.0;
    for (const ConvexPolygon& polygon : body.polygons) {
      const ConvexPolygon p = pdg::placed(polygon, from);
      const ConvexPolygon q = pdg::placed(polygon, to);
      for (std::size_t i = 0; i < p.size(); ++i) {
        expected = std::max(expected, pdg::norm(q[i] - p[i]));
      }
    }
    const pdg::DistanceBounds bounds = pdg::generalized_distance_bounds(body, from, to);
    EXPECT_NEAR(pdg::displacement(body, from, to), expected, 1e-12);
    EXPECT_GE(bounds.lower, expected * (1 - 1e-13));  // or the turn of the smallest circle
    EXPECT_GE(bounds.upper, bounds.lower);
    EXPECT_LE(bounds.upper, bounds.lower * std::numbers::pi / 2 * (1 + 1e-12));
  }
}

}  // namespace
