#include "goal_guesses.hpp"

#include <cmath>
#include <cstddef>

#include "tuning.hpp"

namespace planner {

namespace {

// A low-discrepancy sequence: fractions of n / 2, n / 3 and n / 5 mirrored at the point (Halton).
double mirrored(int n, const int base) {
  double sum = 0.0;
  double digit = 1.0;
  for (; n > 0; n /= base) sum += (digit /= base) * (n % base);
  return sum;
}

}  // namespace

std::vector<Configuration> near_goals(const GoalRegion& region, SegmentTest& segments,
                                      const ScaledProblem& problem, const Configuration& start) {
  std::vector<Configuration> out = region.near(start);
  std::erase_if(out, [&](const Configuration& q) { return !segments.is_free(scaled(problem, q)); });
  return out;
}

std::vector<Configuration> free_goals(const GoalRegion& region, CollisionHint& hint,
                                      const ScaledProblem& problem, const Configuration& start) {
  std::vector<Configuration> out;
  const auto keep_if_free = [&](Configuration q) {
    if (!problem.rotation) q.theta = start.theta;
    if (out.size() < kMostGoalTrees && hint.gap(scaled(problem, q)) >= 0.0) out.push_back(q);
  };
  for (const Configuration& q : region.near(start)) keep_if_free(q);
  for (int n = 1; n <= kGoalSamples; ++n)
    if (const auto q = region.sample(mirrored(n, 2), mirrored(n, 3), mirrored(n, 5)))
      keep_if_free(*q);
  return out;
}

}  // namespace planner
