#include "bracket_slices.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "pdg/native/depth/displacement.hpp"
#include "pdg/native/slices/minkowski_slice.hpp"
#include "pdg/native/slices/turning_core.hpp"
#include "pdg/native/tolerances.hpp"

namespace pdg {
namespace {

// The obstacle is grown by so many slice errors, in turn, until a pose is free. Chosen, not tuned.
constexpr std::array<double, 6> kGrowths{0.0, 1.0, 4.0, 16.0, 64.0, 256.0};

void grow(ObstacleSlice& slice, const double by) {
  for (SlicePlane& plane : slice.planes) plane.offset += by;
  for (ObstacleSlice::Polygon& polygon : slice.polygons) {
    polygon.box.low = polygon.box.low - Vec2{by, by};
    polygon.box.high = polygon.box.high + Vec2{by, by};
  }
}

// The pieces of B that come within `reach` of the origin.
PieceSet near_pieces(const PieceSet& b, const Vec2 origin, const double reach) {
  PieceSet near;
  const Box box{origin - Vec2{reach, reach}, origin + Vec2{reach, reach}};
  for (std::size_t j = 0; j < b.polygons.size(); ++j) {
    if (!boxes_meet(box, bounding_box(b.polygons[j]))) continue;
    near.polygons.push_back(b.polygons[j]);
    near.pieces.push_back(b.pieces[j]);
  }
  return near;
}

}  // namespace

FreePose measured(const PieceSet& body, const Pose& q0, const Pose& pose) {
  const DistanceBounds bounds = generalized_distance_bounds(body, q0, pose);
  const double error =
      kDisplacementErrorUnits * kUnitRoundoff *
      (norm(q0.t) + norm(pose.t) + body.radius * (1.0 + std::abs(q0.theta) + std::abs(pose.theta)));
  return {pose, displacement(body, q0, pose) + error, bounds.upper};
}

double padded_half(const double middle, const double half) {
  return half * kRadiusPadding + kRangeMiddleUnits * kUnitRoundoff * (std::abs(middle) + half);
}

BracketSlices::BracketSlices(const PieceSet& a, const PieceSet& b, const Pose& q0,
                             const double reach)
    : a_(a), b_(b), q0_(q0) {
  hull_ = a.hull;
  circle_ = enclosing_circle_bounds(hull_);
  centre0_ = rotate(rotation_of(q0.theta), circle_.centre) + q0.t;
  for (Vec2& v : hull_) v = v - circle_.centre;
  moving_ = shifted_pieces(a, circle_.centre);
  // Within `reach` the centre's translation is at most that.
  const double near = (circle_.outer + reach) * kRadiusPadding +
                      kSliceErrorUnits * kUnitRoundoff * (norm(circle_.centre) + norm(q0.t));
  fixed_ = shifted_pieces(near_pieces(b, centre0_, near), centre0_);
  input_magnitude_ =
      norm(circle_.centre) + norm(q0.t) + (std::abs(q0.theta) + std::numbers::pi) * circle_.outer;
}

double BracketSlices::turning_bound(const double delta) const {
  return 2.0 * std::sin(0.5 * std::min(std::abs(delta), std::numbers::pi)) * circle_.inner /
         kRadiusPadding;
}

double BracketSlices::widest_turn(const double value) const {
  const double half_sine = 0.5 * value / circle_.inner * kRadiusPadding;
  return half_sine < 1.0 ? std::min(2.0 * std::asin(half_sine) * kRadiusPadding, std::numbers::pi)
                         : std::numbers::pi;
}

// w_v = (R(theta0 + delta) - R(theta0)) v = 2 sin(delta / 2) R(theta0 + delta / 2) v^perp.
void BracketSlices::turn_to(const double delta) {
  ++slices_;
  turn_pieces(moving_, rotation_of(q0_.theta + delta), turned_);
  slice_.planes.clear();
  slice_.polygons.clear();
  const Rotation middle = rotation_of(q0_.theta + 0.5 * delta);
  const double chord = 2.0 * std::sin(0.5 * delta);
  objective_.offsets.clear();
  for (const Vec2 v : hull_) objective_.offsets.push_back(chord * perp(rotate(middle, v)));
  objective_.radius = std::abs(chord) * circle_.inner / kRadiusPadding;
}

Pose BracketSlices::pose_at(const double delta, const Vec2 t) const {
  const double theta = q0_.theta + delta;
  return {centre0_ + t - rotate(rotation_of(theta), circle_.centre), theta};
}

std::optional<FreePose> BracketSlices::nearest_free(const double delta, const double cutoff) {
  turn_to(delta);
  add_near_differences(turned_, fixed_, objective_.reach(cutoff), input_magnitude_, slice_);
  double grown = 0.0;
  for (const double growth : kGrowths) {
    grow(slice_, growth * slice_.error - grown);
    grown = growth * slice_.error;
    const std::optional<SliceMinimum> least =
        least_outside(slice_, objective_, cutoff, SliceUse::kValue);
    if (!least) return std::nullopt;
    const Pose pose = pose_at(delta, least->t);
    if (!interiors_are_disjoint(a_, b_, pose, scratch_)) continue;
    const FreePose found = measured(a_, q0_, pose);
    return found.displacement < cutoff ? std::optional(found) : std::nullopt;
  }
  return std::nullopt;
}

// At a free pose turned by delta + epsilon, |epsilon| <= half, the same translation is outside the
// cores at delta, and every point of A is within 2 r sin(half / 2) of where it is at delta.
double BracketSlices::lower_bound(const double delta, const double half, const double cutoff) {
  const double padded = padded_half(delta, half);
  const double drift = 2.0 * std::sin(0.5 * padded) * circle_.outer * kRadiusPadding;
  turn_to(delta);
  const Turn turn = turn_by(padded);
  const double above = cutoff + drift;
  const double reach = objective_.reach(above);
  const Box disc{{-reach, -reach}, {reach, reach}};
  for (std::size_t i = 0; i < turned_.size(); ++i) {
    for (std::size_t j = 0; j < fixed_.size(); ++j) {
      if (!boxes_meet(difference_box(turned_.boxes[i], fixed_.boxes[j]), disc)) continue;
      add_turning_core(turned_.piece(i), fixed_.piece(j), turn, slice_);
    }
  }
  slice_.error =
      kSliceErrorUnits * kUnitRoundoff * (turned_.reach + fixed_.reach + reach + input_magnitude_);
  const double lost = drift + 4.0 * slice_.error;
  const std::optional<SliceMinimum> least =
      least_outside(slice_, objective_, above, SliceUse::kBound);
  return std::min(cutoff, (least ? least->value : above) - lost);
}

}  // namespace pdg
