#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "pdg/native/bounds/containment.hpp"
#include "pdg/native/bounds/depth_upper_bound.hpp"
#include "pdg/native/geometry/convex_hull.hpp"
#include "pdg/native/geometry/enclosing_circle.hpp"

namespace {

using pdg::HalfPlane;
using pdg::Vec2;

constexpr double kRounding = 1e-11;  // of lengths of the order of 10
constexpr double kInfinity = std::numeric_limits<double>::infinity();

using Random = std::mt19937_64;

double uniform(Random& random, const double low, const double high) {
  return std::uniform_real_distribution<double>(low, high)(random);
}

int pick(Random& random, const int low, const int high) {
  return std::uniform_int_distribution<int>(low, high)(random);
}

// On a coarse grid now and then, so that points coincide and lie on lines and circles.
std::vector<Vec2> random_points(Random& random, const int count) {
  const bool grid = pick(random, 0, 1) == 0;
  std::vector<Vec2> points;
  for (int k = 0; k < count; ++k) {
    const Vec2 p{uniform(random, -3, 3), uniform(random, -3, 3)};
    points.push_back(grid ? Vec2{std::round(p.x), std::round(p.y)} : p);
  }
  return points;
}

double farthest_from(const Vec2 t, const std::vector<Vec2>& points) {
  double most = 0.0;
  for (const Vec2 p : points) most = std::max(most, pdg::norm(p - t));
  return most;
}

// Where the distance from both is the same, as a line.
HalfPlane bisector(const Vec2 p, const Vec2 q) {
  const Vec2 normal = (1.0 / pdg::norm(q - p)) * (q - p);
  return {normal, pdg::dot(normal, 0.5 * (p + q))};
}

// Their common point, far away for parallels.
Vec2 crossing(const HalfPlane& a, const HalfPlane& b) {
  const double sine = pdg::cross(a.normal, b.normal);
  return (1.0 / sine) * Vec2{a.offset * b.normal.y - b.offset * a.normal.y,
                             b.offset * a.normal.x - a.offset * b.normal.x};
}

// All points that can be the nearest: points themselves, middles of two, circumcentres, feet on the
// sides, crossings of sides and bisectors, corners.
std::vector<Vec2> candidates(const std::vector<Vec2>& points, const std::vector<HalfPlane>& sides) {
  std::vector<Vec2> found = points;
  std::vector<HalfPlane> bisectors;
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      found.push_back(0.5 * (points[i] + points[j]));
      if (!(points[i] == points[j])) bisectors.push_back(bisector(points[i], points[j]));
    }
  }
  for (std::size_t i = 0; i < bisectors.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) found.push_back(crossing(bisectors[i], bisectors[j]));
  }
  for (const HalfPlane& side : sides) {
    for (const Vec2 p : points) {
      found.push_back(p + (side.offset - pdg::dot(side.normal, p)) * side.normal);
    }
    for (const HalfPlane& line : bisectors) found.push_back(crossing(side, line));
    for (const HalfPlane& other : sides) found.push_back(crossing(side, other));
  }
  return found;
}

double least_by_brute_force(const std::vector<Vec2>& points, const std::vector<HalfPlane>& sides) {
  double least = kInfinity;
  for (const Vec2 t : candidates(points, sides)) {
    if (!std::isfinite(t.x) || !std::isfinite(t.y)) continue;
    const bool inside = std::all_of(sides.begin(), sides.end(), [&](const HalfPlane& side) {
      return pdg::dot(side.normal, t) <= side.offset + kRounding;
    });
    if (inside) least = std::min(least, farthest_from(t, points));
  }
  return least;
}

TEST(EnclosingCircle, IsTheSmallest) {
  Random random(1);
  for (int k = 0; k < 3000; ++k) {
    const std::vector<Vec2> points = random_points(random, pick(random, 1, 7));
    const pdg::Circle circle = pdg::smallest_enclosing_circle(points);
    EXPECT_NEAR(circle.radius, farthest_from(circle.centre, points), kRounding);
    EXPECT_NEAR(circle.radius, least_by_brute_force(points, {}), kRounding);
  }
}

// Unit normals; on a grid of angles now and then, so that sides are parallel, opposite and equal.
std::vector<HalfPlane> random_sides(Random& random) {
  std::vector<HalfPlane> sides;
  const bool grid = pick(random, 0, 1) == 0;
  const int count = pick(random, 0, 7);
  for (int k = 0; k < count; ++k) {
    const Vec2 axes[] = {{1, 0}, {0, 1}, {-1, 0}, {0, -1}};
    const double angle = uniform(random, -4, 4);
    const Vec2 normal = grid ? axes[pick(random, 0, 3)] : Vec2{std::cos(angle), std::sin(angle)};
    const double offset = uniform(random, -2, 3);
    sides.push_back({normal, grid ? std::round(2 * offset) / 2 : offset});
  }
  return sides;
}

TEST(Containment, NearestPointIsTheLeastOfAllCandidates) {
  Random random(2);
  constexpr double kBound = 1e3;
  int found = 0;
  int empty = 0;
  for (int k = 0; k < 6000; ++k) {
    std::vector<Vec2> points = random_points(random, pick(random, 1, 7));
    const Vec2 centre = pdg::smallest_enclosing_circle(points).centre;
    pdg::FarthestPoint farthest;
    farthest.offsets.clear();
    for (Vec2& p : points) {
      p = p - centre;
      farthest.offsets.push_back(-p);
    }
    farthest.radius = farthest.value({});
    const std::vector<HalfPlane> sides = random_sides(random);
    const double expected = least_by_brute_force(points, sides);
    const auto nearest = pdg::nearest_in_container(farthest, sides, kBound);
    if (!nearest) {
      // A region that is one point may be lost to rounding.
      std::vector<HalfPlane> narrower = sides;
      for (HalfPlane& side : narrower) side.offset -= 10 * kRounding;
      EXPECT_GE(least_by_brute_force(points, narrower), kBound);
      ++empty;
      continue;
    }
    ++found;
    EXPECT_NEAR(nearest->distance, expected, 10 * kRounding);
    EXPECT_NEAR(nearest->distance, farthest_from(nearest->point, points), kRounding);
    for (const HalfPlane& side : sides) {
      EXPECT_LE(pdg::dot(side.normal, nearest->point), side.offset + kRounding);
    }
    const double bound = uniform(random, 0.5, 1.5) * nearest->distance;
    if (std::abs(bound - nearest->distance) < kRounding) continue;
    EXPECT_EQ(pdg::nearest_in_container(farthest, sides, bound).has_value(),
              nearest->distance < bound);
  }
  EXPECT_GT(found, 2000);
  EXPECT_GT(empty, 500);
}

// A square turned by 45 degrees in a square hole: turning by phi, it fits for
// sin(phi) + cos(phi) <= side of the hole; nothing is gained by shifting it.
TEST(Containment, TurnsOntoTheBoundaryOfWhatFits) {
  const pdg::PieceSet square = pdg::make_piece_set({{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}});
  const double half = 1.2;
  const pdg::ConvexSeparator hole{
      {{{1, 0}, half}, {{0, 1}, half}, {{-1, 0}, half}, {{0, -1}, half}}, 0.0};
  const double quarter = std::atan(1.0);
  pdg::TurningBody body;
  pdg::make_turning_body(square, {{0, 0}, quarter}, body);
  pdg::ContainmentScratch scratch;
  int placements = 0;
  const auto placement = pdg::nearest_placement(body, hole, 0.0, 3.0, scratch, placements);
  ASSERT_TRUE(placement.has_value());
  const double widest = 0.5 * std::asin(half * half - 1.0);  // sin(2 phi) = half^2 - 1
  EXPECT_NEAR(std::abs(placement->pose.theta), widest, 1e-7);
  EXPECT_NEAR(placement->displacement, 2.0 * std::sqrt(2.0) * std::sin(0.5 * (quarter - widest)),
              1e-7);
  EXPECT_GT(placements, 4);
  EXPECT_FALSE(pdg::nearest_placement(body, hole, 0.3, 3.0, scratch, placements).has_value());
}

TEST(UpperBound, HullsComeApartWhateverTheirPlace) {
  Random random(3);
  pdg::UpperBoundScratch scratch;
  int overlapping = 0;
  for (int k = 0; k < 5000; ++k) {
    const double far = std::pow(10.0, pick(random, 0, 12));
    const std::vector<Vec2> points_a = random_points(random, 8);
    std::vector<Vec2> points_b = random_points(random, 8);
    const Vec2 shift{uniform(random, -far, far), uniform(random, -far, far)};
    for (Vec2& p : points_b) p = p + shift;
    const pdg::ConvexPolygon a = pdg::convex_hull(points_a);
    const pdg::ConvexPolygon b = pdg::convex_hull(points_b);
    if (a.size() < 3 || b.size() < 3) continue;
    const pdg::PieceSet body = pdg::make_piece_set({a});
    const pdg::PieceSet obstacle = pdg::make_piece_set({b});
    const pdg::Pose pose{shift + Vec2{uniform(random, -2, 2), uniform(random, -2, 2)},
                         uniform(random, -7, 7)};
    const auto bound = pdg::hull_upper_bound(body, obstacle, pose, scratch);
    const auto depth = pdg::translational_depth(pdg::placed(a, pose), b);
    EXPECT_NE(pdg::pair_state(pdg::placed(a, bound.displaced.pose), b), pdg::PairState::kOverlap);
    EXPECT_NEAR(bound.displacement, std::max(depth.depth, 0.0), 1e-13 * (100.0 + far));
    if (depth.state != pdg::PairState::kOverlap) {
      EXPECT_EQ(bound.displacement, 0.0);
    } else {
      ++overlapping;
    }
  }
  EXPECT_GT(overlapping, 2000);
}

}  // namespace
