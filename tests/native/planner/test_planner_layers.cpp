// The two exact deciders of a layer against each other and against a flood fill: ways along free
// corners, and closed odd chains of open sums.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "planar_planner/native/layers/odd_chain.hpp"
#include "planar_planner/native/layers/taut_path.hpp"
#include "random_polygons.hpp"

namespace {

using fuzz::pick;
using fuzz::Random;
using pdg::Vec2;
using planner::find_odd_chain;
using planner::find_taut_path;
using planner::LatticePoint;
using planner::Layer;
using planner::Problem;

constexpr planner::LayerLimits kNoLimits{1'000'000, 10'000'000};

pdg::Polygon rectangle(const double x, const double y, const double width, const double height) {
  return {{{{x, y}, {x + width, y}, {x + width, y + height}, {x, y + height}}}};
}

Layer layer_of(const Problem& problem, const Vec2 start, const Vec2 goal, const int quarters = 0) {
  const auto layer = planner::make_layer(planner::make_scaled_problem(problem),
                                         {quarters, start, goal}, kNoLimits);
  EXPECT_TRUE(layer.has_value());
  return layer.value_or(Layer{});
}

bool free_ends(const Layer& layer) {
  std::vector<std::int32_t> scratch;
  return is_free(layer, layer.start, scratch) && is_free(layer, layer.goal, scratch);
}

// The links overlap in turn, and the way from each overlap to the next winds oddly.
void expect_free_path(const Layer& layer, const std::vector<LatticePoint>& path) {
  ASSERT_FALSE(path.empty());
  EXPECT_EQ(path.front(), layer.start);
  EXPECT_EQ(path.back(), layer.goal);
  for (std::size_t i = 0; i + 1 < path.size(); ++i)
    for (const planner::OpenSum& sum : layer.sums)
      EXPECT_FALSE(meets_segment(sum, path[i], path[i + 1]));
}

// Rectangles with integer corners: on a line of the half-integer grid, what is free is free up to
// the next grid point, so that neighbours of the half-integer grid tell all ways.
bool joined_by_flood(const Layer& layer) {
  const auto open = [&](const LatticePoint doubled) {
    const auto beyond = [](const std::int64_t v, const std::int64_t low, const std::int64_t high) {
      return v < 2 * low || v > 2 * high;
    };
    if (beyond(doubled.x, layer.domain.low.x, layer.domain.high.x)) return false;
    if (beyond(doubled.y, layer.domain.low.y, layer.domain.high.y)) return false;
    return std::none_of(layer.sums.begin(), layer.sums.end(), [&](const planner::OpenSum& sum) {
      return 2 * sum.low.x < doubled.x && doubled.x < 2 * sum.high.x && 2 * sum.low.y < doubled.y &&
             doubled.y < 2 * sum.high.y;
    });
  };
  const LatticePoint goal{2 * layer.goal.x, 2 * layer.goal.y};
  std::vector<LatticePoint> stack{{2 * layer.start.x, 2 * layer.start.y}};
  std::set<LatticePoint> seen(stack.begin(), stack.end());
  while (!stack.empty()) {
    const LatticePoint p = stack.back();
    stack.pop_back();
    if (p == goal) return true;
    for (const LatticePoint step : {LatticePoint{1, 0}, {-1, 0}, {0, 1}, {0, -1}})
      if (open(p + step) && seen.insert(p + step).second) stack.push_back(p + step);
  }
  return false;
}

struct Tally {
  int paths = 0;
  int chains = 0;
};

void decide(const Layer& layer, Tally& tally) {
  const auto chain = find_odd_chain(layer);
  const auto path = find_taut_path(layer);
  ASSERT_NE(chain.has_value(), path.has_value());
  if (chain) {
    ++tally.chains;
    EXPECT_GE(chain->size(), 3U);
  } else {
    ++tally.paths;
    expect_free_path(layer, *path);
  }
}

TEST(Layers, RectanglesAgreeWithAFloodFill) {
  Tally tally;
  for (std::uint32_t seed = 0; seed < 20'000; ++seed) {
    Random random(seed);
    Problem problem;
    const int size = pick(random, 4, 12);
    problem.box = planner::Rectangle{{0, 0}, {double(size), double(size)}};
    // One piece or an L of two.
    problem.robot.append(rectangle(0, 0, pick(random, 1, 2), pick(random, 1, 2)));
    if (pick(random, 0, 2) == 0) problem.robot.append(rectangle(0, 0, pick(random, 1, 3), 1));
    for (int k = pick(random, 1, size * size / 2); k > 0; --k)
      problem.obstacles.append(rectangle(pick(random, 0, size), pick(random, 0, size),
                                         pick(random, 1, 3), pick(random, 1, 3)));
    const auto place = [&] {
      return Vec2{double(pick(random, 0, size)), double(pick(random, 0, size))};
    };
    const Layer layer = layer_of(problem, place(), place());
    if (!free_ends(layer)) continue;
    decide(layer, tally);
    EXPECT_EQ(find_taut_path(layer).has_value(), joined_by_flood(layer)) << seed;
  }
  EXPECT_GT(tally.paths, 1'500);
  EXPECT_GT(tally.chains, 250);
}

pdg::Polygon small_triangle(Random& random, const int size) {
  for (;;) {
    const auto point = [&] {
      return Vec2{double(pick(random, 0, size)), double(pick(random, 0, size))};
    };
    const Vec2 a = point();
    const Vec2 b = point();
    const Vec2 c = point();
    const double area = cross(b - a, c - a);
    if (area == 0.0) continue;
    return area > 0 ? pdg::Polygon{{{a, b, c}}} : pdg::Polygon{{{a, c, b}}};
  }
}

// Small integer triangles meet, touch and share edges often.
TEST(Layers, SlantedScenesHaveAPathOrAnOddChain) {
  Tally tally;
  for (std::uint32_t seed = 0; seed < 20'000; ++seed) {
    Random random(seed);
    Problem problem;
    const int size = pick(random, 4, 10);
    problem.box = planner::Rectangle{{0, 0}, {double(size), double(size)}};
    problem.robot.append(small_triangle(random, 2));
    for (int k = pick(random, 1, 20); k > 0; --k)
      problem.obstacles.append(small_triangle(random, size));
    const auto place = [&] {
      return Vec2{double(pick(random, 0, size)), double(pick(random, 0, size))};
    };
    const Layer layer = layer_of(problem, place(), place(), pick(random, 0, 3));
    if (free_ends(layer)) decide(layer, tally);
  }
  EXPECT_GT(tally.paths, 300);
  EXPECT_GT(tally.chains, 100);
}

TEST(Layers, ALatticeHoldsWhatFitsAndRefusesTheRest) {
  const std::vector<double> fits = {0.5, -3.0, 1024.0};
  ASSERT_TRUE(planner::common_lattice(fits).has_value());
  EXPECT_EQ(planner::common_lattice(fits)->exponent, -1);
  const std::vector<double> wide = {1e-20, 1.0};
  EXPECT_FALSE(planner::common_lattice(wide).has_value());
  EXPECT_EQ(planner::double_below((std::int64_t{1} << 60) + 1), std::int64_t{1} << 60);
  EXPECT_EQ(planner::double_above((std::int64_t{1} << 60) + 1), (std::int64_t{1} << 60) + 256);
  EXPECT_EQ(planner::double_below(-(std::int64_t{1} << 60) - 1), -(std::int64_t{1} << 60) - 256);
}

TEST(Layers, ProductsCompareExactly) {
  const auto big = static_cast<planner::Int128>(1) << 120;
  EXPECT_EQ(planner::compare_products(big, big, big, big), 0);
  EXPECT_EQ(planner::compare_products(big + 1, big - 1, big, big), -1);
  EXPECT_EQ(planner::compare_products(-big, big, big, big), -1);
  EXPECT_EQ(planner::compare_products(-big, -big - 1, big, big), 1);
}

}  // namespace
