#include "depth_upper_bound.hpp"

#include <algorithm>
#include <stdexcept>

#include "displacement.hpp"
#include "tolerances.hpp"
#include "translational_depth.hpp"

namespace pdg {
namespace {

// Doublings of the way beyond touching before a placement is given up.
constexpr int kMostDoublings = 4;

void place_hull(const PieceSet& body, const Pose& pose, ConvexPolygon& result) {
  const Rotation rotation = rotation_of(pose.theta);
  result.clear();
  for (const Vec2 v : body.hull) result.push_back(rotate(rotation, v) + pose.t);
}

}  // namespace

DepthUpperBound hull_upper_bound(const PieceSet& a, const PieceSet& b, const Pose& pose,
                                 UpperBoundScratch& scratch) {
  place_hull(a, pose, scratch.hull);
  const TranslationalDepth depth = translational_depth(scratch.hull, b.hull);
  DepthUpperBound bound;
  bound.displaced = bound.distanced = {pose, UpperBoundSource::kHulls, -1};
  if (depth.state != PairState::kOverlap) return bound;
  double beyond =
      kSeparationErrorUnits * kUnitRoundoff * (a.radius + b.radius + norm(pose.t) + depth.depth);
  for (int attempt = 0; attempt <= kMostDoublings; ++attempt, beyond *= 2.0) {
    const Pose moved{pose.t + (depth.depth + beyond) * depth.direction, pose.theta};
    if (!interiors_are_disjoint(a, b, moved, scratch.depth)) continue;
    bound.displaced.pose = bound.distanced.pose = moved;
    bound.displacement = bound.distance = norm(moved.t - pose.t);
    return bound;
  }
  throw std::logic_error("hulls that do not come apart");
}

namespace {

// Takes a free placement's distances over where they are the least yet.
void take(const PieceSet& a, const Pose& from, const FreePlacement& placement,
          DepthUpperBound& bound) {
  const DistanceBounds moved = generalized_distance_bounds(a, from, placement.pose);
  if (moved.lower < bound.displacement) {
    bound.displacement = moved.lower;
    bound.displaced = placement;
  }
  if (moved.upper < bound.distance) {
    bound.distance = moved.upper;
    bound.distanced = placement;
  }
}

// The separators that may improve the bound, the most promising first.
void order_separators(const TurningBody& body, const std::vector<ConvexSeparator>& separators,
                      const double bound, std::vector<std::pair<double, std::size_t>>& order) {
  order.clear();
  for (std::size_t k = 0; k < separators.size(); ++k) {
    const double least = least_way_in(body, separators[k]);
    if (least < bound) order.emplace_back(least, k);
  }
  std::sort(order.begin(), order.end());
}

}  // namespace

DepthUpperBound separator_upper_bound(const PieceSet& a, const PieceSet& b,
                                      const std::vector<ConvexSeparator>& separators,
                                      const Pose& pose, UpperBoundScratch& scratch) {
  DepthUpperBound bound;
  bound.displaced = bound.distanced = {pose, UpperBoundSource::kFree, -1};
  if (interiors_are_disjoint(a, b, pose, scratch.depth)) return bound;
  bound = hull_upper_bound(a, b, pose, scratch);
  make_turning_body(a, pose, scratch.body);
  order_separators(scratch.body, separators, bound.displacement, scratch.order);
  for (const auto& [least, k] : scratch.order) {
    if (least >= bound.displacement) break;
    // Twice: where the container lies, and where rounding puts A's vertices in it.
    double margin =
        separators[k].error + kSeparationErrorUnits * kUnitRoundoff *
                                  (a.radius + b.radius + norm(pose.t) + bound.displacement);
    for (int attempt = 0; attempt <= kMostDoublings; ++attempt, margin *= 2.0) {
      const auto placement =
          nearest_placement(scratch.body, separators[k], margin, bound.displacement,
                            scratch.containment, bound.placements);
      if (!placement) break;
      if (!interiors_are_disjoint(a, b, placement->pose, scratch.depth)) continue;
      take(a, pose, {placement->pose, UpperBoundSource::kSeparator, static_cast<int>(k)}, bound);
      break;
    }
  }
  return bound;
}

}  // namespace pdg
