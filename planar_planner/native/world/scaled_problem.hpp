// The problem in planner units: origin at the centre of the domain, scaled by a power of two so
// that the domain's larger half-extent lies in [1/2, 1). Rounding is then relative to the scene's
// size, wherever the scene lies.
#pragma once

#include <optional>

#include "obstacle_tree.hpp"
#include "planar_planner/native/ablation.hpp"
#include "problem.hpp"
#include "robot.hpp"

namespace planner {

// Everything outside the domain is forbidden to the reference point.
struct Domain {
  Vec2 low;
  Vec2 size;
  double reach = 0.0;  // max |t| over the domain, rounded up
};

struct ScaledProblem {
  Problem given;
  PolygonSet outside;  // what lies outside a polygonal workspace, as obstacles (world frame)
  pdg::Frame frame;
  Robot robot;
  Domain domain;
  std::optional<Rectangle> reference_bounds;  // user's units
  std::vector<pdg::ConvexPiece> walls;        // half-planes; empty without a workspace
  bool rotation = true;
  Ablation ablation;
};

ScaledProblem make_scaled_problem(Problem given, const Ablation& ablation = {});

inline Obstacles all_obstacles(const ScaledProblem& problem) {
  return {problem.given.obstacles, problem.outside};
}

inline Vec2 to_planner(const ScaledProblem& problem, const Vec2 p) {
  return pdg::to_frame(problem.frame, p);
}
Vec2 to_user(const ScaledProblem& problem, Vec2 p);
double length_to_user(const ScaledProblem& problem, double length);

}  // namespace planner
