#include "disc.hpp"

#include <cmath>
#include <numbers>

#include "planar_planner/native/tolerances.hpp"
#include "tuning.hpp"

namespace planner {

namespace {

PolygonSet regular_polygon(const double radius) {
  Polygon polygon{{{}}};
  for (int i = 0; i < kDiscSides; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / kDiscSides;
    polygon.rings[0].push_back({radius * std::cos(angle), radius * std::sin(angle)});
  }
  PolygonSet set;
  set.append(polygon);
  return set;
}

Problem with_robot(const ScaledProblem& problem, PolygonSet robot) {
  Problem out = problem.given;
  out.robot = std::move(robot);
  out.rotation = false;
  return out;
}

}  // namespace

std::optional<DiscProblems> disc_problems(const ScaledProblem& problem) {
  const Robot& robot = problem.robot;
  if (!problem.rotation || robot.inner_reach <= 0.0 || robot.reach > kDiscRatio * robot.inner_reach)
    return std::nullopt;
  constexpr double slack = kDiscUnits * pdg::kUnitRoundoff;
  const double outer = length_to_user(problem, robot.reach) * (1.0 + slack) /
                       std::cos(std::numbers::pi / kDiscSides);
  const double inner = length_to_user(problem, robot.inner_reach) * (1.0 - slack);
  return DiscProblems{with_robot(problem, regular_polygon(outer)),
                      with_robot(problem, regular_polygon(inner))};
}

}  // namespace planner
