#include "depth_upper_bound.hpp"

#include <algorithm>
#include <stdexcept>

#include "displacement.hpp"
#include "tolerances.hpp"
#include "translational_depth.hpp"

namespace pdg {
namespace {

// Doublings of the way beyond touching before a placement is given up.
constexpr int kMostDoublings = 8;

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

}  // namespace pdg
