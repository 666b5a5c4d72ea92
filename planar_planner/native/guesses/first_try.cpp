#include "first_try.hpp"

#include <algorithm>

#include "planar_planner/native/paths/path.hpp"
#include "tuning.hpp"

namespace planner {

FirstTry::FirstTry(const ScaledProblem& problem, ObstacleTree& tree, SegmentTest& segments,
                   CollisionHint& hint, Statistics& statistics, const Clock& clock,
                   const Configuration& start, const std::span<const Configuration> goals)
    : problem_(problem),
      tree_(tree),
      segments_(segments),
      hint_(hint),
      statistics_(statistics),
      clock_(clock),
      trees_(problem, hint, start, goals),
      spacing_(kTrySpacing * problem.robot.reach) {}

std::vector<Configuration> FirstTry::go_on(const std::uint64_t work, const Terminator& stop) {
  const std::uint64_t until = this->work() + work;
  while (this->work() < until && !stop()) {
    std::vector<Configuration> path;
    {
      const Stopwatch watch(clock_, statistics_.seconds.probe);
      const std::uint64_t calls = hint_.calls();
      path = trees_.find(spacing_, until - certificates_, stop);
      statistics_.probe_checks += hint_.calls() - calls;
    }
    if (path.empty()) return {};
    const Stopwatch watch(clock_, statistics_.seconds.path);
    if (certify(path, stop)) return path;
  }
  return {};
}

bool FirstTry::certify(std::vector<Configuration>& path, const Terminator& stop) {
  const std::uint64_t before = statistics_.separation_evaluations;
  const auto bad = certify_shortened(problem_, tree_, segments_, hint_, path, stop);
  const std::uint64_t evaluated = statistics_.separation_evaluations - before;
  evaluations_ += evaluated;
  certificates_ += kEvaluationWork * evaluated;
  if (!bad) return true;
  trees_.reject(*bad);
  spacing_ = std::max(kFinerSpacing * spacing_, kFinestSpacing * problem_.robot.reach);
  return false;
}

}  // namespace planner
