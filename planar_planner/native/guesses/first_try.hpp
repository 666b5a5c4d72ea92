// The first try: two random trees, of whose path only its certificate is believed. It is done in
// slices of work, so that it can take turns with the cells; a failure proves nothing.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "planar_planner/native/limits.hpp"
#include "planar_planner/native/paths/collision.hpp"
#include "planar_planner/native/paths/segment.hpp"
#include "planar_planner/native/statistics.hpp"
#include "planar_planner/native/stopwatch.hpp"
#include "rrt_connect.hpp"

namespace planner {

class FirstTry {
 public:
  // What it borrows must outlive it. At least one goal.
  FirstTry(const ScaledProblem& problem, ObstacleTree& tree, SegmentTest& segments,
           CollisionHint& hint, Statistics& statistics, const Clock& clock,
           const Configuration& start, std::span<const Configuration> goals);

  // Goes on until it has done so much more work, or the terminator strikes. A certified path,
  // shortened, or nothing. Units as of RrtConnect::work.
  std::vector<Configuration> go_on(std::uint64_t work, const Terminator& stop);

  // All of it so far, certificates included.
  [[nodiscard]] std::uint64_t work() const { return trees_.work() + certificates_; }
  // Do the trees still reach new places?
  [[nodiscard]] bool promising() const { return trees_.growing(); }
  [[nodiscard]] std::size_t bytes() const { return trees_.bytes(); }
  // Separating-axis functions evaluated for its certificates: they stand in the statistics.
  [[nodiscard]] std::uint64_t evaluations() const { return evaluations_; }

 private:
  bool certify(std::vector<Configuration>& path, const Terminator& stop);

  const ScaledProblem& problem_;
  ObstacleTree& tree_;
  SegmentTest& segments_;
  CollisionHint& hint_;
  Statistics& statistics_;
  const Clock& clock_;
  RrtConnect trees_;
  double spacing_;
  std::uint64_t certificates_ = 0;  // their work
  std::uint64_t evaluations_ = 0;
};

}  // namespace planner
