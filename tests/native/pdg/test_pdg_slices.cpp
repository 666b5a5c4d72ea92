// Minkowski slices and what they are made of, against brute force.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "pdg/native/bounds/bracket.hpp"
#include "pdg/native/geometry/convex_hull.hpp"
#include "pdg/native/geometry/enclosing_circle.hpp"
#include "pdg/native/slices/farthest_point.hpp"
#include "pdg/native/slices/slice_pieces.hpp"
#include "pdg/native/slices/turning_core.hpp"
#include "random_polygons.hpp"

namespace {

using fuzz::pick;
using fuzz::Random;
using pdg::ConvexPolygon;
using pdg::Vec2;

double uniform(Random& random, const double low, const double high) {
  return std::uniform_real_distribution<double>(low, high)(random);
}

ConvexPolygon random_convex(Random& random, const double size) {
  for (;;) {
    std::vector<Vec2> points;
    for (int k = pick(random, 3, 8); k > 0; --k) {
      points.push_back({uniform(random, -size, size), uniform(random, -size, size)});
    }
    ConvexPolygon hull = pdg::convex_hull(std::move(points));
    if (hull.size() >= 3) return hull;
  }
}

pdg::SlicePieces turned(const ConvexPolygon& polygon, const double angle) {
  const pdg::SlicePieces pieces = pdg::shifted_pieces({polygon}, Vec2{});
  pdg::SlicePieces result;
  pdg::turn_pieces(pieces, pdg::rotation_of(angle), result);
  return result;
}

// How deep t lies inside the only polygon of a slice.
double depth(const pdg::ObstacleSlice& slice, const Vec2 t) {
  double least = std::numeric_limits<double>::infinity();
  for (const pdg::SlicePlane& plane : slice.planes) {
    least = std::min(least, plane.offset - dot(plane.normal, t));
  }
  return least;
}

TEST(TurningCore, LiesInEverySliceOfTheTurn) {
  Random random(51);
  int inside = 0;
  int near = 0;
  for (int trial = 0; trial < 400; ++trial) {
    // Parallel edges and common normals now and then.
    const ConvexPolygon a = trial % 4 == 0 ? ConvexPolygon{{-2, -1}, {2, -1}, {2, 1}, {-2, 1}}
                                           : random_convex(random, 3.0);
    const ConvexPolygon b = trial % 3 == 0 ? ConvexPolygon{{-1, -3}, {4, -3}, {4, 2}, {-1, 2}}
                                           : random_convex(random, 4.0);
    const double angle = trial % 4 == 0 ? 0.0 : uniform(random, -4.0, 4.0);
    const double half = std::pow(10.0, uniform(random, -4.0, 0.1));
    const pdg::SlicePieces fixed = pdg::shifted_pieces({b}, Vec2{});
    const pdg::SlicePieces middle = turned(a, angle);
    pdg::ObstacleSlice core;
    pdg::add_turning_core(middle.piece(0), fixed.piece(0), pdg::turn_by(half), core);
    std::vector<pdg::ObstacleSlice> slices;
    for (int k = 0; k <= 40; ++k) {
      const double delta = half * (k / 20.0 - 1.0);
      pdg::add_difference(turned(a, angle + delta).piece(0), fixed.piece(0), slices.emplace_back());
    }
    for (int k = 0; k < 60; ++k) {
      const Vec2 t{uniform(random, -7.0, 7.0), uniform(random, -7.0, 7.0)};
      double least = std::numeric_limits<double>::infinity();
      for (const pdg::ObstacleSlice& slice : slices) least = std::min(least, depth(slice, t));
      const double in_core = depth(core, t);
      if (in_core > 0.0) {
        ++inside;
        EXPECT_GT(least, -1e-12) << trial;
      }
      // Equal to the intersection but for terms of second order.
      if (least > 4.0 * half * half + 1e-9) {
        ++near;
        EXPECT_GT(in_core, 0.0) << trial << " half-angle " << half;
      }
    }
  }
  EXPECT_GT(inside, 2000);
  EXPECT_GT(near, 2000);
}

TEST(FarthestPoint, IsLeastWhereSamplesSay) {
  Random random(52);
  for (int trial = 0; trial < 300; ++trial) {
    pdg::FarthestPoint f;
    f.offsets.clear();
    for (int k = pick(random, 1, 12); k > 0; --k) {
      f.offsets.push_back({uniform(random, -1.0, 1.0), uniform(random, -1.0, 1.0)});
    }
    if (trial % 5 == 0) f.offsets.assign(3, f.offsets.front());
    const double angle = uniform(random, -4.0, 4.0);
    const Vec2 along{std::cos(angle), std::sin(angle)};
    const pdg::Line line{uniform(random, -2.0, 2.0) * pdg::perp(along), along};
    const double low = uniform(random, -3.0, 1.0);
    const double high = low + uniform(random, 0.0, 4.0);
    const double s = f.least_on(line, low, high);
    ASSERT_TRUE(s >= low && s <= high);
    const double least = f.value(point_at(line, s));
    for (int k = 0; k <= 200; ++k) {
      const double other = low + (high - low) * k / 200.0;
      EXPECT_LE(least, f.value(point_at(line, other)) + 1e-14);
    }
  }
}

TEST(EnclosingCircle, BoundsBothSidesOfTheRadius) {
  Random random(53);
  for (int trial = 0; trial < 500; ++trial) {
    std::vector<Vec2> points;
    for (int k = pick(random, 1, 20); k > 0; --k) {
      points.push_back({uniform(random, -1.0, 1.0), uniform(random, -1.0, 1.0)});
      if (trial % 7 == 0) points.back().y = points.back().x;
      if (trial % 3 == 0)
        points.back() = {std::round(3.0 * points.back().x), std::round(3.0 * points.back().y)};
    }
    const pdg::CircleBounds bounds = pdg::enclosing_circle_bounds(points);
    EXPECT_LE(bounds.inner, bounds.outer);
    EXPECT_NEAR(bounds.inner, bounds.outer, 1e-12);
    for (const Vec2 p : points) EXPECT_LE(norm(p - bounds.centre), bounds.outer);
    // The invariant that FarthestPoint and the bracket rest on.
    for (int k = 0; k < 20; ++k) {
      const Vec2 t{uniform(random, -1.0, 1.0), uniform(random, -1.0, 1.0)};
      double farthest = 0.0;
      for (const Vec2 p : points) farthest = std::max(farthest, norm(t + (p - bounds.centre)));
      EXPECT_GE(farthest, std::hypot(norm(t), bounds.inner) - 1e-14);
    }
  }
}

TEST(EnclosingCircle, InnerRadiusHoldsFarFromTheOrigin) {
  Random random(59);
  for (int trial = 0; trial < 300; ++trial) {
    const Vec2 far{uniform(random, -1e10, 1e10), uniform(random, -1e10, 1e10)};
    const Vec2 a = far + Vec2{uniform(random, -1.0, 1.0), uniform(random, -1.0, 1.0)};
    const Vec2 b = far + Vec2{uniform(random, -1.0, 1.0), uniform(random, -1.0, 1.0)};
    const long double dx = static_cast<long double>(b.x) - a.x;
    const long double dy = static_cast<long double>(b.y) - a.y;
    EXPECT_LE(pdg::enclosing_circle_bounds({a, b}).inner, 0.5L * std::sqrt(dx * dx + dy * dy));
  }
}

// Any angle is followed down to ranges as narrow as the bracket makes; those beside a seam between
// two ranges fall into a gap that rounding leaves, if they are not padded.
TEST(BracketSlices, PaddedRangesLeaveNoGap) {
  Random random(61);
  for (int trial = 0; trial < 20000; ++trial) {
    const double first = uniform(random, 0.0, 3.0) / 8;
    const int k = pick(random, 0, 7);
    double half = first;
    double middle = first * (2 * k - 7);
    const long double share = pick(random, 0, 1 << 20) / static_cast<long double>(1 << 20);
    const long double angle = static_cast<long double>(first) * (2 * k - 8 + 2 * share);
    for (int level = 0; level < 46; ++level) {
      EXPECT_LE(std::abs(angle - middle), pdg::padded_half(middle, half)) << level;
      half *= 0.5;
      middle += angle < middle ? -half : half;
    }
  }
}

pdg::PieceSet random_body(Random& random, const int parts) {
  std::vector<ConvexPolygon> polygons;
  for (int k = 0; k < parts; ++k) {
    ConvexPolygon part = random_convex(random, 1.5);
    const Vec2 shift{uniform(random, -2.0, 2.0), uniform(random, -2.0, 2.0)};
    for (Vec2& v : part) v = v + shift;
    polygons.push_back(std::move(part));
  }
  return pdg::make_piece_set(std::move(polygons));
}

TEST(BracketSlices, BoundsOfRangesHoldAtTheirAngles) {
  Random random(54);
  int tight = 0;
  for (int trial = 0; trial < 150; ++trial) {
    const pdg::PieceSet a = random_body(random, 3);
    const pdg::PieceSet b = random_body(random, 6);
    const pdg::Pose q0{{uniform(random, -1.0, 1.0), uniform(random, -1.0, 1.0)},
                       uniform(random, -4.0, 4.0)};
    constexpr double kReach = 10.0;
    pdg::BracketSlices slices(a, b, q0, kReach);
    const double middle = uniform(random, -1.5, 1.5);
    const double half = std::pow(10.0, uniform(random, -3.0, 0.0));
    const double bound = slices.lower_bound(middle, half, kReach);
    double least = kReach;
    for (int k = 0; k <= 20; ++k) {
      const auto found = slices.nearest_free(middle + half * (k / 10.0 - 1.0), kReach);
      if (found) least = std::min(least, found->displacement);
    }
    EXPECT_LE(bound, least) << trial;
    tight += bound > least - 8.0 * half - 1e-9;
  }
  EXPECT_GT(tight, 120);
}

TEST(Bracket, FewNodesHoldWhatManyFind) {
  Random random(55);
  for (int trial = 0; trial < 40; ++trial) {
    const pdg::PieceSet a = random_body(random, 3);
    const pdg::PieceSet b = random_body(random, 6);
    const pdg::Pose q0{{uniform(random, -1.0, 1.0), uniform(random, -1.0, 1.0)},
                       uniform(random, -4.0, 4.0)};
    const pdg::Bracket fine = pdg::bracket_depth(a, b, q0, {1e-5, 100000, {}});
    for (const unsigned nodes : {0U, 4U, 16U, 64U}) {
      const pdg::Bracket coarse = pdg::bracket_depth(a, b, q0, {1e-5, nodes, {}});
      EXPECT_LE(coarse.lower, fine.displaced.displacement);
      EXPECT_GE(coarse.displaced.displacement, fine.lower);
      EXPECT_LE(coarse.nodes, nodes);
    }
    if (fine.lower > 0.0) {
      EXPECT_LE(fine.displaced.displacement - fine.lower, 1e-5 * fine.displaced.displacement);
    }
  }
}

}  // namespace
