#include "pose.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace planner {

Pose pose_of(const Problem& problem, const Configuration& q) {
  return {to_planner(problem, {q.x, q.y}), q.theta};
}

Configuration configuration_of(const Problem& problem, const Pose& pose) {
  Vec2 p = to_user(problem, pose.t);
  if (problem.reference_bounds) {
    const Rectangle& r = *problem.reference_bounds;
    p = {std::clamp(p.x, r.low.x, r.high.x), std::clamp(p.y, r.low.y, r.high.y)};
  }
  return {p.x, p.y, pose.theta};
}

double nearest_turn(const double angle, const double theta) {
  constexpr double turn = 2.0 * std::numbers::pi;
  return angle + turn * std::round((theta - angle) / turn);
}

}  // namespace planner
