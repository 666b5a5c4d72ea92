#include "ridge_attempts.hpp"

#include "planar_planner/native/paths/path.hpp"
#include "tuning.hpp"

namespace planner {

bool RidgeAttempts::due() const {
  const Ablation& ablation = problem_.ablation;
  const bool now =
      statistics_.labelled_cells >= next_cells_ || statistics_.axis_work() >= next_work_;
  return ablation.ridge && ablation.guided && now;
}

std::vector<Configuration> RidgeAttempts::attempt(const std::vector<CellId>& channel,
                                                  const Configuration& start,
                                                  const Configuration& goal,
                                                  const Terminator& stop) {
  ++statistics_.ridge_tries;
  const std::uint64_t before = statistics_.axis_work();
  std::vector<Configuration> path =
      ridge_.find(channel, start, goal, kLeastWork + before / kWorkShare, stop);
  const std::uint64_t after = statistics_.axis_work();
  next_cells_ = kCellGrowth * statistics_.labelled_cells;
  next_work_ = after + kWorkRatio * (after - before);
  if (path.empty()) return {};
  CollisionHint hint(problem_, tree_);
  if (certify_shortened(problem_, tree_, segments_, hint, path, stop)) return {};
  return path;
}

}  // namespace planner
