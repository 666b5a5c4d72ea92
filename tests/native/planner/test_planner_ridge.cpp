// Steps and climbs onto the ridge of the clearance, against brute force.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "planar_planner/native/guesses/max_min.hpp"
#include "planar_planner/native/guesses/ridge.hpp"
#include "planner_worlds.hpp"

namespace {

using planner::Height;
using planner::LinearTerm;
using planner::PairAxis;
using planner::RidgeClimb;
using planner::ScaledConfiguration;
using planner::Step3;
using worlds::Random;
using worlds::Real;
using worlds::World;

double least(const std::vector<LinearTerm>& terms, const Step3& d) {
  double value = std::numeric_limits<double>::infinity();
  for (const LinearTerm& t : terms) value = std::min(value, t.value + planner::dot(t.gradient, d));
  return value;
}

double gain(const std::vector<LinearTerm>& terms, const Step3& d, const double price) {
  return least(terms, d) - 0.5 * price * planner::dot(d, d);
}

// The function is concave: what no small step improves is the maximum.
double best_nearby(Random& random, const std::vector<LinearTerm>& terms, const Step3& from,
                   const double price) {
  double best = -std::numeric_limits<double>::infinity();
  for (int i = 0; i < 3000; ++i) {
    const double size = std::exp(worlds::uniform(random, -14.0, 2.0));
    Step3 d = from;
    for (double& x : d) x += size * worlds::uniform(random, -1.0, 1.0);
    best = std::max(best, gain(terms, d, price));
  }
  return best;
}

TEST(PlannerRidge, StepsAreOptimal) {
  int balanced = 0;
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    std::vector<LinearTerm> terms;
    for (int i = worlds::pick(random, 1, 12); i > 0; --i) {
      LinearTerm term{worlds::uniform(random, -1.0, 1.0), {}};
      const int flat = worlds::pick(random, 0, 3);  // many gradients in one plane, or opposed
      for (int k = 0; k < 3; ++k)
        term.gradient[static_cast<std::size_t>(k)] =
            k == flat ? 0.0 : static_cast<double>(worlds::pick(random, -2, 2));
      terms.push_back(term);
      if (worlds::pick(random, 0, 3) == 0) terms.push_back(term);
    }
    const double price = std::exp(worlds::uniform(random, -3.0, 3.0));
    const planner::MaxMinStep step = planner::max_min_step(terms, price);
    EXPECT_DOUBLE_EQ(step.least, least(terms, step.d));
    EXPECT_LE(best_nearby(random, terms, step.d, price), gain(terms, step.d, price) + 1e-11);
    const auto active = std::count_if(terms.begin(), terms.end(), [&](const LinearTerm& t) {
      return t.value + planner::dot(t.gradient, step.d) < step.least + 1e-12;
    });
    if (active > 1) ++balanced;
  }
  EXPECT_GT(balanced, 100);
}

TEST(PlannerRidge, StepsGoToWhereTermsBalanceAndNoFarther) {
  const std::vector<LinearTerm> walls{{0.3, {1.0, 0.0, 0.0}}, {-0.1, {-1.0, 0.0, 0.0}}};
  const planner::MaxMinStep step = planner::max_min_step(walls, 1.0);
  EXPECT_DOUBLE_EQ(step.d[0], -0.2);
  EXPECT_EQ(step.d[1], 0.0);
  EXPECT_EQ(step.d[2], 0.0);
  EXPECT_DOUBLE_EQ(step.least, 0.1);
}

// All axes of all pairs.
std::vector<PairAxis> all_axes(const World& world, const RidgeClimb& climb) {
  planner::ObstacleTree tree(all_obstacles(world.problem), world.problem.frame,
                             world.problem.walls);
  planner::Statistics statistics;
  planner::Ablation flat;
  flat.hierarchy = false;
  planner::Labeller labeller(world.problem.robot, tree, statistics, flat);
  planner::ConstraintList root;
  labeller.root_list(root);
  std::vector<PairAxis> axes;
  climb.add_axes(planner::view(root), axes);
  RidgeClimb::sort_axes(axes);
  return axes;
}

TEST(PlannerRidge, ClimbsEndHigherAndTellTheClearance) {
  int higher = 0;
  const std::vector<worlds::Recipe> recipes = worlds::recipes();
  for (std::uint64_t seed = 0; seed < 45; ++seed) {
    SCOPED_TRACE(seed);
    Random random(900 + seed);
    World world(worlds::random_scene(random, recipes[seed % recipes.size()]));
    world.tree.expand_all();
    planner::Statistics statistics;
    RidgeClimb climb(world.problem, world.tree, statistics);
    const std::vector<PairAxis> axes = all_axes(world, climb);
    const planner::Domain& d = world.problem.domain;
    for (int i = 0; i < 20; ++i) {
      const ScaledConfiguration from{{d.low.x + d.size.x * worlds::uniform(random, 0.0, 1.0),
                                      d.low.y + d.size.y * worlds::uniform(random, 0.0, 1.0)},
                                     worlds::uniform(random, -3.0, 3.0)};
      const auto height = [&](const ScaledConfiguration& q) {
        return static_cast<double>(world.oracle.separation({q.t.x, q.t.y, q.theta}));
      };
      const Height top = climb.climb(from, worlds::uniform(random, 0.01, 0.5), axes);
      EXPECT_NEAR(top.clearance, height(top.q), 1e-12);
      EXPECT_GE(top.clearance, height(from) - 1e-12);
      if (top.clearance > height(from) + 1e-6) ++higher;
    }
  }
  EXPECT_GT(higher, 500);
}

// A rectangle 3 x 1 in a slot 2 long, turned by `angle`; the ridge is the slot's middle line.
planner::Problem slot(const double angle, const double clearance) {
  const auto turned = [&](const pdg::Vec2 p) {
    return pdg::Vec2{std::cos(angle) * p.x - std::sin(angle) * p.y,
                     std::sin(angle) * p.x + std::cos(angle) * p.y};
  };
  const auto block = [&](const double y0, const double y1) {
    return pdg::Polygon{
        {{turned({-1.0, y0}), turned({1.0, y0}), turned({1.0, y1}), turned({-1.0, y1})}}};
  };
  planner::Problem scene;
  scene.robot.append(pdg::Polygon{{{{-1.5, -0.5}, {1.5, -0.5}, {1.5, 0.5}, {-1.5, 0.5}}}});
  scene.box = planner::Rectangle{{-10.0, -10.0}, {10.0, 10.0}};
  scene.obstacles.append(block(0.5 * (1.0 + clearance), 12.0));
  scene.obstacles.append(block(-12.0, -0.5 * (1.0 + clearance)));
  return scene;
}

TEST(PlannerRidge, ClimbsReachTheMiddleOfASlot) {
  for (const double angle : {0.4, -1.1, 0.9})
    for (const double clearance : {1e-2, 1e-5, 1e-9}) {
      World world(slot(angle, clearance));
      world.tree.expand_all();
      planner::Statistics statistics;
      RidgeClimb climb(world.problem, world.tree, statistics);
      const std::vector<PairAxis> axes = all_axes(world, climb);
      const double widest = std::ldexp(0.5 * clearance, world.problem.frame.exponent);
      Random random(5);
      for (int i = 0; i < 50; ++i) {
        const ScaledConfiguration from{
            {worlds::uniform(random, -0.01, 0.01), worlds::uniform(random, -0.01, 0.01)},
            angle + worlds::uniform(random, -0.1, 0.1)};
        const Height top = climb.climb(from, 0.2, axes);
        EXPECT_GE(top.clearance, 0.5 * widest) << angle << ' ' << clearance;
        EXPECT_LE(top.clearance, widest + 1e-14);
        EXPECT_LT(pdg::norm(top.q.t - from.t), 0.05);
      }
    }
}

}  // namespace
