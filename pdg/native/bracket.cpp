#include "bracket.hpp"

#include <algorithm>
#include <cmath>
#include <queue>
#include <vector>

#include "bracket_slices.hpp"
#include "convex_hull.hpp"
#include "displacement.hpp"
#include "generalized_depth.hpp"
#include "nonconvex_depth.hpp"
#include "tolerances.hpp"

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

// To begin with the turns in question are cut into so many ranges.
constexpr int kFirstRanges = 8;

// The way out of the hulls' overlap, lengthened until the pose is free.
FreePose out_of_hulls(const PieceSet& a, const PieceSet& b, const Pose& q0) {
  const TranslationalDepth hulls =
      translational_depth(convex_hull(placed(a, q0)), convex_hull(b.polygons));
  const double extent = a.radius + norm(q0.t) + b.radius;
  for (double more = kUnitRoundoff * extent;; more *= 2.0) {
    const Pose pose{q0.t + (hulls.depth + more) * hulls.direction, q0.theta};
    if (interiors_meet(placed(a, pose), b)) continue;
    const double error = kDisplacementErrorUnits * kUnitRoundoff * (extent + norm(pose.t));
    return {pose, displacement(a, q0, pose) + error};
  }
}

class BranchAndBound {
 public:
  BranchAndBound(const PieceSet& a, const PieceSet& b, const Pose& q0, const BracketLimits& limits)
      : limits_(limits), best_(out_of_hulls(a, b, q0)), slices_(a, b, q0, best_.displacement) {
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
    result_.upper = best_.displacement;
    result_.pose = best_.pose;
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
    return slices_.turning_bound(std::max(0.0, std::abs(middle) - half * kRadiusPadding));
  }

  BracketEnd search() {
    for (;;) {
      if (best_.displacement - lower() <= limits_.rel_tol * best_.displacement) {
        return BracketEnd::kTolerance;
      }
      if (result_.nodes >= limits_.nodes) return BracketEnd::kNodes;
      if (limits_.stop && limits_.stop()) return BracketEnd::kStopped;
      const Range range = ranges_.top();
      const double half = 0.5 * range.half;
      if (half <= kUnitRoundoff * std::abs(range.middle)) return BracketEnd::kRounding;
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
    return found.has_value();
  }

  // Walks downhill over the angle from an angle that improves on the best pose, if this one does.
  void descend(double delta, double step) {
    if (!improve(delta)) return;
    while (step * slices_.radius() > kDescentEnd * limits_.rel_tol * best_.displacement) {
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

  // The descent ends at steps that move A by this part of what the tolerance allows.
  static constexpr double kDescentEnd = 0.05;

  const BracketLimits& limits_;
  FreePose best_;
  BracketSlices slices_;
  double least_ = 0.0;
  std::priority_queue<Range, std::vector<Range>, LaterFirst> ranges_;
  Bracket result_;
};

}  // namespace

Bracket bracket_depth(const PieceSet& a, const PieceSet& b, const Pose& q0,
                      const BracketLimits& limits) {
  if (!interiors_meet(placed(a, q0), b)) {
    Bracket apart;
    apart.pose = q0;
    return apart;
  }
  return BranchAndBound(a, b, q0, limits).run();
}

}  // namespace pdg
