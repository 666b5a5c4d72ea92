#include "ridge_attempts.hpp"

#include "planar_planner/native/paths/path.hpp"

namespace planner {

namespace {

// Tried again when so many times as many cells have been labelled, or the work since the last try
// is so many times its own. Work is counted in evaluations of separating-axis functions.
constexpr std::uint64_t kGrowth = 2;
constexpr std::uint64_t kPatience = 20;
// What a try may cost: so much, and one part in so many of the work before.
constexpr std::uint64_t kWork = 1000;
constexpr std::uint64_t kShare = 24;

}  // namespace

bool RidgeAttempts::due() const {
  const Parts& parts = problem_.parts;
  const bool now =
      statistics_.labelled_cells >= next_cells_ || statistics_.axis_work() >= next_work_;
  return parts.ridge && parts.guided && now;
}

std::vector<Configuration> RidgeAttempts::attempt(const std::vector<CellId>& channel,
                                                  const Configuration& start,
                                                  const Configuration& goal,
                                                  const Terminator& stop) {
  const Stopwatch watch(statistics_.seconds.path);
  ++statistics_.ridge_tries;
  const std::uint64_t before = statistics_.axis_work();
  std::vector<Configuration> path =
      ridge_.find(channel, start, goal, kWork + before / kShare, stop);
  const std::uint64_t after = statistics_.axis_work();
  next_cells_ = kGrowth * statistics_.labelled_cells;
  next_work_ = after + kPatience * (after - before);
  if (path.empty()) return {};
  CollisionHint hint(problem_, tree_);
  if (certify_shortened(problem_, tree_, segments_, hint, path, stop)) return {};
  return path;
}

}  // namespace planner
