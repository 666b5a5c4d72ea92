// Continuous certificates of straight motions: linear in (x, y, theta), bisected until every
// sub-interval is FREE by the same labelling as cells, never sampled.
#pragma once

#include <cmath>
#include <optional>
#include <vector>

#include "planar_planner/native/configurations/pose.hpp"
#include "planar_planner/native/labels/label.hpp"
#include "planar_planner/native/world/problem.hpp"

namespace planner {

// A part of a segment, 0 <= begin <= end <= 1.
struct Interval {
  double begin, end;
};

Pose between(const Pose& from, const Pose& to, double s);
// The configurations of that part of the segment, coupled (pdg::Motion::turn).
pdg::Motion motion_along(const Problem& problem, const Pose& from, const Pose& to,
                         Interval interval);
inline pdg::Rotation rotation_at(const double theta) {
  return {std::cos(theta), std::sin(theta)};
}

class SegmentTest {
 public:
  SegmentTest(const Problem& problem, Labeller& labeller, Statistics& statistics)
      : problem_(problem), labeller_(labeller), statistics_(statistics), posed_(problem.robot) {}

  // True: every configuration from one pose to the other is free, in exact arithmetic, also for the
  // real poses that these doubles were rounded from. False: collides, or needs too many intervals.
  // With a margin, they are free by at least that much along the separating axes.
  bool certify(const Pose& from, const Pose& to, double margin = 0.0);

  // Lower bound of this single configuration's clearance, planner units; empty if it is not proven
  // free.
  std::optional<double> clearance(const Pose& pose);
  [[nodiscard]] bool is_free(const Pose& pose) { return clearance(pose).has_value(); }

 private:
  bool certify_interval(const Pose& from, const Pose& to, Interval interval,
                        const ConstraintView& parent, std::size_t depth);

  const Problem& problem_;
  Labeller& labeller_;
  Statistics& statistics_;
  PosedRobot posed_;
  std::vector<ConstraintList> lists_;  // one per depth
  int budget_ = 0;
  double margin_ = 0.0;
};

}  // namespace planner
