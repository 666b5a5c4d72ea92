// Continuous certificates of straight motions: linear in (x, y, theta), bisected until every
// sub-interval is FREE by the same labelling as cells, never sampled.
#pragma once

#include <limits>
#include <optional>
#include <vector>

#include "label.hpp"
#include "pose.hpp"
#include "problem.hpp"

namespace planner {

// Of the separation along the axes: a lower bound of the Euclidean clearance. Planner units.
struct ClearanceBounds {
  double lower = std::numeric_limits<double>::infinity();
  double upper = std::numeric_limits<double>::infinity();
};

class SegmentTest {
 public:
  SegmentTest(const Problem& problem, Labeller& labeller, Statistics& statistics)
      : problem_(problem), labeller_(labeller), statistics_(statistics) {}

  // True: every configuration from one pose to the other is free, in exact arithmetic, also for the
  // real poses that these doubles were rounded from. False: collides, or needs too many intervals.
  // With a margin: by at least that much, along the separating axes.
  bool certify(const Pose& from, const Pose& to, double margin = 0.0);

  // Lowers `clearance` to hold along a certified segment too. `lower` stays a certified bound of the
  // clearance, within the factor 1 - tolerance of `upper`, the least value found at any point, unless
  // `intervals` run out.
  void bound_clearance(const Pose& from, const Pose& to, double tolerance, int intervals,
                       ClearanceBounds& clearance);

  // Is this single configuration free?
  bool is_free(const Pose& pose);

 private:
  struct Interval {
    double begin, end;
  };
  bool certify_interval(const Pose& from, const Pose& to, Interval interval,
                        const ConstraintView& parent, std::size_t depth);
  double clearance_of(const Pose& from, const Pose& to, Interval interval);
  [[nodiscard]] pdg::Motion motion_along(const Pose& from, const Pose& to, Interval interval) const;

  const Problem& problem_;
  Labeller& labeller_;
  Statistics& statistics_;
  std::vector<ConstraintList> lists_;  // one per depth
  int budget_ = 0;
  double margin_ = 0.0;
};

}  // namespace planner
