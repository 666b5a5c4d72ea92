#include "depth_upper_bound.hpp"

#include <algorithm>
#include <limits>
#include <stdexcept>

#include "pdg/native/depth/displacement.hpp"
#include "pdg/native/depth/placed_outline.hpp"
#include "pdg/native/tolerances.hpp"
#include "tuning.hpp"

namespace pdg {
namespace {

// Whether all of A's vertices, placed in doubles, are beyond the line along B's hull: for certain,
// as the hull is beyond it by more than all rounding, that of vertices within it included.
bool is_beyond(const PlacedBody& hull, const PieceSet& b, const Vec2 normal) {
  double least = std::numeric_limits<double>::infinity();
  double most = -least;
  for (const Vec2 v : hull.vertices) least = std::min(least, dot(normal, v));
  for (const Vec2 v : b.hull) most = std::max(most, dot(normal, v));
  return least - most > hull.error;
}

}  // namespace

DepthUpperBound hull_upper_bound(const PieceSet& a, const PieceSet& b, const Pose& pose,
                                 UpperBoundScratch& scratch) {
  PlacedBody& hull = scratch.hull;
  place_hull(a, pose, b.radius, hull);
  DepthUpperBound bound;
  bound.displaced = bound.distanced = {pose, UpperBoundSource::kHulls, -1};
  const Separation separation =
      pair_separation(hull, 0, b.hull_piece, std::numeric_limits<double>::infinity());
  // Decided exactly where rounding leaves it open.
  if (separation.value >= -hull.error) {
    ConvexPolygon placed_hull = hull.vertices;
    restore_convexity(placed_hull);
    if (separation.value > hull.error || pair_state(placed_hull, b.hull) != PairState::kOverlap) {
      return bound;
    }
  }
  const double depth = std::max(-separation.value, 0.0);
  double beyond = 4.0 * hull.error;
  for (int attempt = 0; attempt <= kMostDoublings; ++attempt, beyond *= 2.0) {
    const Pose moved{pose.t + (depth + beyond) * separation.normal, pose.theta};
    place_hull(a, moved, b.radius, hull);
    if (!is_beyond(hull, b, separation.normal) &&
        !interiors_are_disjoint(a, b, moved, scratch.depth)) {
      continue;
    }
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
  const double displaced = displacement(a, from, placement.pose);
  const DistanceBounds moved = generalized_distance_bounds(a, from, placement.pose);
  if (displaced < bound.displacement) {
    bound.displacement = displaced;
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

namespace {

Pose between(const Pose& from, const Pose& to, const double share) {
  return {from.t + share * (to.t - from.t), from.theta + share * (to.theta - from.theta)};
}

void draw_back(const PieceSet& a, const PieceSet& b, const Pose& from, FreePlacement placement,
               DepthUpperBound& bound, UpperBoundScratch& scratch) {
  const Pose far = placement.pose;
  const auto is_free = [&](const double share) {
    return interiors_are_disjoint(a, b, between(from, far, share), scratch.depth);
  };
  int sample = 1;
  while (sample < kSamplesBack && !is_free(sample / double{kSamplesBack})) ++sample;
  double blocked = (sample - 1) / double{kSamplesBack};
  double free = sample / double{kSamplesBack};
  if (free == 1.0 && !is_free(1.0)) return;
  for (int halving = 0; halving < kHalvingsBack; ++halving) {
    const double middle = 0.5 * (blocked + free);
    (is_free(middle) ? free : blocked) = middle;
  }
  placement.pose = between(from, far, free);
  placement.drawn_back = true;
  take(a, from, placement, bound);
}

}  // namespace

DepthUpperBound drawn_back_upper_bound(const PieceSet& a, const PieceSet& b,
                                       const std::vector<ConvexSeparator>& separators,
                                       const Pose& pose, UpperBoundScratch& scratch) {
  DepthUpperBound bound = separator_upper_bound(a, b, separators, pose, scratch);
  if (bound.displacement == 0.0) return bound;
  const FreePlacement inside = bound.displaced;
  draw_back(a, b, pose, inside, bound, scratch);
  if (inside.source != UpperBoundSource::kHulls) {
    draw_back(a, b, pose, hull_upper_bound(a, b, pose, scratch).displaced, bound, scratch);
  }
  return bound;
}

}  // namespace pdg
