// When a path is guessed through a channel that is still MIXED, and what that may cost: now and
// then, in proportion to the work of the search. All of it is counted, so answers do not depend on
// the machine.
#pragma once

#include <cstdint>
#include <vector>

#include "planar_planner/native/cells/subdivision.hpp"
#include "planar_planner/native/limits.hpp"
#include "planar_planner/native/paths/segment.hpp"
#include "ridge_path.hpp"
#include "tuning.hpp"

namespace planner {

class RidgeAttempts {
 public:
  RidgeAttempts(const ScaledProblem& problem, ObstacleTree& tree, const Subdivision& subdivision,
                SegmentTest& segments, Statistics& statistics)
      : problem_(problem),
        tree_(tree),
        segments_(segments),
        statistics_(statistics),
        ridge_(problem, tree, subdivision, segments, statistics) {}

  [[nodiscard]] bool due() const;
  // A certified path through the channel; empty if none was found, or the terminator struck.
  std::vector<Configuration> attempt(const std::vector<CellId>& channel, const Configuration& start,
                                     const Configuration& goal, const Terminator& stop);

 private:
  const ScaledProblem& problem_;
  ObstacleTree& tree_;
  SegmentTest& segments_;
  Statistics& statistics_;
  RidgePath ridge_;
  std::uint64_t next_cells_ = kFirstAttempt;  // Statistics::labelled_cells that make it due ...
  std::uint64_t next_work_ = UINT64_MAX;      // ... or Statistics::axis_work()
};

}  // namespace planner
