// Continuous certificates of straight motions: linear in (x, y, theta), bisected until every
// sub-interval is FREE by the same labelling as cells, never sampled.
#pragma once

#include <optional>
#include <vector>

#include "planar_planner/native/configurations/quarter_turn.hpp"
#include "planar_planner/native/configurations/scaled_configuration.hpp"
#include "planar_planner/native/labels/label.hpp"
#include "planar_planner/native/world/scaled_problem.hpp"

namespace planner {

// A part of a segment, 0 <= begin <= end <= 1.
struct Interval {
  double begin, end;
};

ScaledConfiguration between(const ScaledConfiguration& from, const ScaledConfiguration& to,
                            double s);
// The configurations of that part of the segment, coupled (pdg::Motion::turn).
pdg::Motion motion_along(const ScaledProblem& problem, const ScaledConfiguration& from,
                         const ScaledConfiguration& to, Interval interval);

class SegmentTest {
 public:
  SegmentTest(const ScaledProblem& problem, Labeller& labeller, Statistics& statistics)
      : problem_(problem), labeller_(labeller), statistics_(statistics), posed_(problem.robot) {}

  // True: every configuration on the straight way from `from` to `to` is free, in exact arithmetic,
  // also for the real configurations that these doubles were rounded from. False: collides, or
  // needs too many intervals. With a margin, they are free by at least that much along the
  // separating axes.
  bool certify(const ScaledConfiguration& from, const ScaledConfiguration& to, double margin = 0.0);

  // Lower bound of this single configuration's clearance, planner units; empty if it is not proven
  // free.
  std::optional<double> clearance(const ScaledConfiguration& q);
  [[nodiscard]] bool is_free(const ScaledConfiguration& q) { return clearance(q).has_value(); }

 private:
  bool certify_interval(const ScaledConfiguration& from, const ScaledConfiguration& to,
                        Interval interval, const ConstraintView& parent, std::size_t depth);

  const ScaledProblem& problem_;
  Labeller& labeller_;
  Statistics& statistics_;
  PosedRobot posed_;
  std::vector<ConstraintList> lists_;  // one per depth
  int budget_ = 0;
  double margin_ = 0.0;
};

}  // namespace planner
