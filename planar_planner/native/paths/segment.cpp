#include "segment.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "planar_planner/native/labels/star.hpp"
#include "planar_planner/native/tolerances.hpp"
#include "tuning.hpp"

namespace planner {

ScaledConfiguration between(const ScaledConfiguration& from, const ScaledConfiguration& to,
                            const double s) {
  return {from.t + s * (to.t - from.t), from.theta + s * (to.theta - from.theta)};
}

pdg::Motion motion_along(const ScaledProblem& problem, const ScaledConfiguration& from,
                         const ScaledConfiguration& to, const Interval i) {
  const double half = 0.5 * (i.end - i.begin);
  const double reach = std::max(problem.domain.reach,
                                std::max(pdg::norm(from.t), pdg::norm(to.t)) * pdg::kRadiusPadding);
  pdg::Motion m =
      pdg::make_segment_motion(between(from, to, 0.5 * (i.begin + i.end)).t, half * (to.t - from.t),
                               half * (to.theta - from.theta), reach);
  // theta is rounded once at its own magnitude, here and when the configuration was made.
  m.angle_error =
      kPoseAngleUnits * pdg::kUnitRoundoff * std::max(std::abs(from.theta), std::abs(to.theta));
  return m;
}

std::optional<double> SegmentTest::clearance(const ScaledConfiguration& q) {
  ConstraintList root;
  labeller_.root_list(root);
  const pdg::Motion m = motion_along(problem_, q, q, {0.0, 1.0});
  posed_.turn_to(rotation_at(q.theta));
  const LabelResult result = labeller_.label(m, posed_, view(root));
  if (result.label != Label::kFree) return std::nullopt;
  return result.clearance;
}

bool SegmentTest::certify(const ScaledConfiguration& from, const ScaledConfiguration& to,
                          const double margin) {
  margin_ = margin;
  ++statistics_.segments_tested;
  if (lists_.size() < kDeepestInterval + 2) lists_.resize(kDeepestInterval + 2);
  labeller_.root_list(lists_[0]);
  budget_ = kMostIntervals;
  return certify_interval(from, to, {0.0, 1.0}, view(lists_[0]), 1);
}

bool SegmentTest::certify_interval(const ScaledConfiguration& from, const ScaledConfiguration& to,
                                   const Interval interval, const ConstraintView& parent,
                                   const std::size_t depth) {
  if (depth > kDeepestInterval || --budget_ < 0) return false;
  const double middle = 0.5 * (interval.begin + interval.end);
  pdg::Motion motion = motion_along(problem_, from, to, interval);
  motion.margin = margin_;
  ConstraintView list = parent;
  if (motion.half_angle <= std::numbers::pi / 2) {
    const ScaledConfiguration centre = between(from, to, middle);
    posed_.turn_to(rotation_at(centre.theta));
    LabelResult result = labeller_.label(motion, posed_, parent, std::move(lists_[depth]));
    lists_[depth] = std::move(result.undecided);
    if (result.label == Label::kFree) return true;
    if (result.label == Label::kFull) return false;
    list = view(lists_[depth]);
    const bool all_open = std::none_of(list.pairs.begin(), list.pairs.end(), closed);
    if (all_open &&
        !planner::is_free(labeller_.tree(), posed_, motion.t, motion.reach, list, margin_))
      return false;
  }
  return certify_interval(from, to, {interval.begin, middle}, list, depth + 1) &&
         certify_interval(from, to, {middle, interval.end}, list, depth + 1);
}

}  // namespace planner
