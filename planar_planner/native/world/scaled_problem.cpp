#include "scaled_problem.hpp"

#include <algorithm>
#include <cmath>

#include "planar_planner/native/tolerances.hpp"

namespace planner {

namespace {

Rectangle intersection(const Rectangle& a, const Rectangle& b) {
  return {{std::max(a.low.x, b.low.x), std::max(a.low.y, b.low.y)},
          {std::min(a.high.x, b.high.x), std::min(a.high.y, b.high.y)}};
}

// The plane between the workspace and a larger rectangle, and the workspace's holes, as obstacles.
// The rectangle only has to reach beyond the bounds; the walls keep the robot inside them.
PolygonSet outside_of(const Polygon& workspace, const Rectangle& bounds) {
  PolygonSet outside;
  const double margin = std::max(bounds.high.x - bounds.low.x, bounds.high.y - bounds.low.y);
  const Vec2 low{bounds.low.x - margin, bounds.low.y - margin};
  const Vec2 high{bounds.high.x + margin, bounds.high.y + margin};
  outside.append({{{low, {high.x, low.y}, high, {low.x, high.y}}, workspace.rings[0]}});
  for (std::size_t r = 1; r < workspace.rings.size(); ++r) outside.append({{workspace.rings[r]}});
  return outside;
}

pdg::Frame make_frame(const Rectangle& bounds) {
  pdg::Frame frame;
  frame.origin = {0.5 * bounds.low.x + 0.5 * bounds.high.x,
                  0.5 * bounds.low.y + 0.5 * bounds.high.y};
  const double half =
      std::max(0.5 * bounds.high.x - 0.5 * bounds.low.x, 0.5 * bounds.high.y - 0.5 * bounds.low.y);
  frame.exponent = half > 0.0 ? -std::ilogb(half) - 1 : 0;
  return frame;
}

// Where the reference point can be at all: a body point at distance hull_distance lies in the box,
// or a whole disc of radius inner_reach does.
Rectangle reachable(const Rectangle& box, const Robot& robot) {
  const double grow = robot.hull_distance;
  const double shrink = robot.inner_reach;
  const double by = grow > 0.0 ? grow : -shrink;
  Rectangle out{{box.low.x - by, box.low.y - by}, {box.high.x + by, box.high.y + by}};
  if (out.low.x >= out.high.x || out.low.y >= out.high.y) out = box;
  return out;
}

Domain make_domain(const Rectangle& box) {
  Domain domain;
  // Bounds of a reference point that is far from the body lie far outside the unit square.
  const double farthest = std::max(
      {1.0, std::abs(box.low.x), std::abs(box.low.y), std::abs(box.high.x), std::abs(box.high.y)});
  const double slack = kDomainUnits * pdg::kUnitRoundoff * farthest;
  domain.low = {box.low.x - slack, box.low.y - slack};
  domain.size = {box.high.x - box.low.x + 2 * slack, box.high.y - box.low.y + 2 * slack};
  const double x = std::max(std::abs(box.low.x), std::abs(box.high.x));
  const double y = std::max(std::abs(box.low.y), std::abs(box.high.y));
  domain.reach = (pdg::norm({x, y}) + 4 * slack) * pdg::kRadiusPadding;
  return domain;
}

std::vector<pdg::ConvexPiece> make_walls(const Rectangle& box) {
  return {pdg::make_half_plane({1, 0}, box.low.x), pdg::make_half_plane({-1, 0}, -box.high.x),
          pdg::make_half_plane({0, 1}, box.low.y), pdg::make_half_plane({0, -1}, -box.high.y)};
}

}  // namespace

ScaledProblem make_scaled_problem(Problem given, const Ablation& ablation) {
  ScaledProblem problem;
  problem.ablation = ablation;
  problem.rotation = given.rotation;
  problem.reference_bounds = given.reference_bounds;
  std::optional<Rectangle> body = given.box;
  if (given.workspace) {
    PolygonSet outline;
    outline.append(*given.workspace);
    body = outline.bounds(0);
    problem.outside = outside_of(*given.workspace, *body);
  }
  const Rectangle bounds = given.reference_bounds.value_or(Rectangle{});
  problem.frame = make_frame(body.value_or(bounds));
  problem.robot = make_robot(given.robot, problem.frame.exponent, ablation.partition);

  const auto framed = [&](const Rectangle& r) {
    return Rectangle{to_planner(problem, r.low), to_planner(problem, r.high)};
  };
  if (body) problem.walls = make_walls(framed(*body));
  Rectangle domain = body ? reachable(framed(*body), problem.robot) : framed(bounds);
  if (body && given.reference_bounds) {
    const Rectangle both = intersection(domain, framed(bounds));
    if (both.low.x <= both.high.x && both.low.y <= both.high.y) domain = both;
  }
  problem.domain = make_domain(domain);
  problem.given = std::move(given);
  return problem;
}

Vec2 to_user(const ScaledProblem& problem, const Vec2 p) {
  return {std::ldexp(p.x, -problem.frame.exponent) + problem.frame.origin.x,
          std::ldexp(p.y, -problem.frame.exponent) + problem.frame.origin.y};
}

double length_to_user(const ScaledProblem& problem, const double length) {
  return std::ldexp(length, -problem.frame.exponent);
}

}  // namespace planner
