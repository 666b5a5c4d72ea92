// The slices of one bracketing problem: A's least displacement from a pose q0 to the free poses at
// one angle, and a lower bound of it over a range of angles. Turns delta are relative to q0's
// angle; a slice's translation is that of the centre of A's smallest enclosing circle.
#pragma once

#include <cstdint>
#include <optional>

#include "pdg/native/depth/generalized_depth.hpp"
#include "pdg/native/geometry/enclosing_circle.hpp"
#include "pdg/native/pieces/piece_set.hpp"
#include "pdg/native/slices/farthest_point.hpp"
#include "pdg/native/slices/slice_pieces.hpp"

namespace pdg {

struct FreePose {
  Pose pose;
  double displacement = 0.0;  // DISP(q0, pose), rounded up
  double distance = 0.0;      // an upper bound of D_g(q0, pose), rounded up
};

// A free pose with its distances from q0.
FreePose measured(const PieceSet& body, const Pose& q0, const Pose& pose);

// The half-width with which ranges of turns that were halved again and again cover every angle,
// their middles' rounding included.
double padded_half(double middle, double half);

class BracketSlices {
 public:
  // `reach`: an upper bound of PD^g under DISP.
  BracketSlices(const PieceSet& a, const PieceSet& b, const Pose& q0, double reach);

  // Below this no turn by delta can stay: 2 sin(|delta| / 2) times the radius of A's circle.
  [[nodiscard]] double turning_bound(double delta) const;

  // The greatest |delta| <= pi at which the bound above is at most `value`, rounded up.
  [[nodiscard]] double widest_turn(double value) const;

  // A free pose at the angle, if there is one of displacement below `cutoff`, and the nearest up to
  // rounding: where the slice's minimum overlaps by rounding, the obstacle is grown by some
  // roundings until the pose is free. Free: no interiors of pieces meet, decided exactly for the
  // vertices as placed in doubles.
  std::optional<FreePose> nearest_free(double delta, double cutoff);

  // A lower bound, at most `cutoff`, of DISP(q0, q) over the free poses q with angles within `half`
  // (less than pi / 2) of delta. Rigorous: holds for the exact geometry of the doubles given.
  double lower_bound(double delta, double half, double cutoff);

  // The radius of A's circle, rounded up.
  [[nodiscard]] double radius() const { return circle_.outer; }
  // Rounding error of the last slice (length).
  [[nodiscard]] double error() const { return slice_.error; }
  [[nodiscard]] std::uint64_t slices() const { return slices_; }

 private:
  void turn_to(double delta);
  [[nodiscard]] Pose pose_at(double delta, Vec2 t) const;

  const PieceSet& a_;
  const PieceSet& b_;
  Pose q0_;
  CircleBounds circle_;
  Vec2 centre0_;                 // where q0 puts the circle's centre
  std::vector<Vec2> hull_;       // A's, from the circle's centre
  SlicePieces moving_, turned_;  // from the circle's centre
  SlicePieces fixed_;            // from centre0_
  ObstacleSlice slice_;
  FarthestPoint objective_;
  double input_magnitude_ = 0.0;
  DepthScratch scratch_;
  std::uint64_t slices_ = 0;
};

}  // namespace pdg
