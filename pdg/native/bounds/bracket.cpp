#include "bracket.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <queue>
#include <vector>

#include "bracket_slices.hpp"
#include "depth_upper_bound.hpp"
#include "pdg/native/depth/generalized_depth.hpp"
#include "pdg/native/tolerances.hpp"
#include "tuning.hpp"

namespace pdg {
namespace {

// A range of turns that may hold the optimum.
struct Range {
  double lower = 0.0;  // of DISP over its free poses
  double middle = 0.0;
  double half = 0.0;
};

struct LaterFirst {
  bool operator()(const Range& a, const Range& b) const {
    return a.lower != b.lower ? a.lower > b.lower : std::abs(a.middle) > std::abs(b.middle);
  }
};

DepthUpperBound first_bound(const PieceSet& a, const PieceSet& b, const Pose& q0,
                            const std::vector<ConvexSeparator>& separators) {
  UpperBoundScratch scratch;
  return drawn_back_upper_bound(a, b, separators, q0, scratch);
}

class BranchAndBound {
 public:
  BranchAndBound(const PieceSet& a, const PieceSet& b, const Pose& q0, const BracketLimits& limits,
                 const DepthUpperBound& known)
      : limits_(limits),
        best_(measured(a, q0, known.displaced.pose)),
        nearest_(measured(a, q0, known.distanced.pose)),
        slices_(a, b, q0, best_.displacement) {
    // PD^t of pieces bounds PD^g from below under DISP ([PDG] section 6.1).
    const double error =
        kDepthErrorUnits * kUnitRoundoff * (2.0 * a.radius + 2.0 * norm(q0.t) + 2.0 * b.radius);
    least_ = std::max(0.0, generalized_depth_lower_bound(a, b, q0).depth - error);
  }

  Bracket run() {
    descend(0.0, slices_.widest_turn(best_.displacement) / kFirstRanges);
    split_first();
    result_.end = search();
    result_.lower = std::min(lower(), best_.displacement);
    result_.displaced = best_;
    result_.distanced = nearest_;
    result_.slices = slices_.slices();
    return result_;
  }

 private:
  [[nodiscard]] double lower() const {
    return ranges_.empty() ? best_.displacement : ranges_.top().lower;
  }

  void split_first() {
    const double widest = slices_.widest_turn(best_.displacement);
    const double half = widest / kFirstRanges;
    for (int k = 0; k < kFirstRanges; ++k) {
      const double middle = half * (2 * k + 1 - kFirstRanges);
      ranges_.push({std::max(least_, nearest_turn_bound(middle, half)), middle, half});
    }
  }

  [[nodiscard]] double nearest_turn_bound(const double middle, const double half) const {
    return slices_.turning_bound(std::max(0.0, std::abs(middle) - padded_half(middle, half)));
  }

  BracketEnd search() {
    for (;;) {
      if (best_.displacement - lower() <= limits_.rel_tol * best_.displacement) {
        return BracketEnd::kTolerance;
      }
      if (result_.nodes + 2 > limits_.nodes) return BracketEnd::kNodes;
      if (limits_.stop && limits_.stop()) return BracketEnd::kStopped;
      const Range range = ranges_.top();
      const double half = 0.5 * range.half;
      if (half * slices_.radius() < slices_.error()) return BracketEnd::kRounding;
      ranges_.pop();
      judge({range.lower, range.middle - half, half});
      judge({range.lower, range.middle + half, half});
    }
  }

  void judge(Range range) {
    ++result_.nodes;
    range.lower = std::max(range.lower, nearest_turn_bound(range.middle, range.half));
    if (range.lower < best_.displacement) {
      range.lower =
          std::max(range.lower, slices_.lower_bound(range.middle, range.half, best_.displacement));
    }
    if (range.lower >= best_.displacement) return;
    ranges_.push(range);
    descend(range.middle, range.half);
  }

  bool improve(const double delta) {
    const std::optional<FreePose> found = slices_.nearest_free(delta, best_.displacement);
    if (found) best_ = *found;
    if (found && found->distance < nearest_.distance) nearest_ = *found;
    return found.has_value();
  }

  // Walks downhill over the angle from an angle that improves on the best pose, if this one does.
  void descend(double delta, double step) {
    if (!improve(delta)) return;
    while (step * slices_.radius() >
           std::max(kDescentEnd * limits_.rel_tol * best_.displacement, slices_.error())) {
      if (improve(delta + step)) {
        delta += step;
      } else if (improve(delta - step)) {
        delta -= step;
        step = -step;
      } else {
        step *= 0.5;
      }
      step = std::abs(step);
    }
  }

  const BracketLimits& limits_;
  FreePose best_;     // under DISP
  FreePose nearest_;  // under D_g
  BracketSlices slices_;
  double least_ = 0.0;
  std::priority_queue<Range, std::vector<Range>, LaterFirst> ranges_;
  Bracket result_;
};

}  // namespace

Bracket bracket_depth(const PieceSet& a, const PieceSet& b, const Pose& q0,
                      const BracketLimits& limits, const std::vector<ConvexSeparator>& separators) {
  DepthScratch scratch;
  if (interiors_are_disjoint(a, b, q0, scratch)) {
    Bracket apart;
    apart.displaced.pose = apart.distanced.pose = q0;
    return apart;
  }
  return BranchAndBound(a, b, q0, limits, first_bound(a, b, q0, separators)).run();
}

}  // namespace pdg
