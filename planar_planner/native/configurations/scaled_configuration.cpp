#include "scaled_configuration.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "dyadic_box.hpp"
#include "quarter_turn.hpp"

namespace planner {

ScaledConfiguration scaled(const ScaledProblem& problem, const Configuration& q) {
  return {to_planner(problem, {q.x, q.y}), q.theta};
}

Configuration configuration_of(const ScaledProblem& problem, const ScaledConfiguration& q) {
  Vec2 p = to_user(problem, q.t);
  if (problem.reference_bounds) {
    const Rectangle& r = *problem.reference_bounds;
    p = {std::clamp(p.x, r.low.x, r.high.x), std::clamp(p.y, r.low.y, r.high.y)};
  }
  return {p.x, p.y, q.theta};
}

std::array<std::uint64_t, 3> dyadic_point(const ScaledProblem& problem, const Configuration& q) {
  const Domain& d = problem.domain;
  const Vec2 t = to_planner(problem, {q.x, q.y});
  const auto count = [](const double fraction) {
    const double clamped = std::clamp(fraction, 0.0, 1.0);
    return std::min(
        static_cast<std::uint64_t>(std::ldexp(clamped, static_cast<int>(kCoordinateBits))),
        kUnit - 1);
  };
  // The library's reduction keeps a few u of a turn whatever theta's magnitude.
  const pdg::Rotation r = rotation_at(q.theta);
  const double turn = std::atan2(r.sin, r.cos) / (2.0 * std::numbers::pi);
  return {count((t.x - d.low.x) / d.size.x), count((t.y - d.low.y) / d.size.y),
          problem.rotation ? count(turn - std::floor(turn)) : 0};
}

}  // namespace planner
