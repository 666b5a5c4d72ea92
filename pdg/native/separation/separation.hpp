// Separation of one pair of convex pieces (A moving, B fixed) over a whole set of configurations.
//
// Separating-axis functions, outward unit normals (docs/method.md, "Labels"):
//   obstacle edge (n, d):  s(q) = min over vertices a of A of n . (R(theta) a + t) - d
//   robot edge (m, c):     s(q) = min over vertices b of B of R(theta) m . (b - t) - c
// The pair is apart or touching iff some s >= 0; when all are negative PD^t = -max s.
// Over a Motion each s has a range [lo, hi]; lo is attained up to the coupling of t and theta, hi
// is the maximum of the lower envelope of sinusoids (ends, aligned edges, peaks).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "pdg/native/geometry/convex_piece.hpp"
#include "pdg/native/geometry/motion.hpp"
#include "pdg/native/tolerances.hpp"

namespace pdg {

enum class EdgeOwner : std::uint8_t { kObstacle = 0, kRobot = 1 };

// One active separating-axis function of a pair: an edge of its owner and the cyclic range of the
// other piece's vertices that can be the minimiser somewhere in the motion.
struct Constraint {
  std::uint16_t edge;
  std::uint16_t first;
  std::uint16_t count;
  EdgeOwner owner;
  std::uint8_t padding;
};

struct Range {
  double lo;
  double hi;
  double turning = 0.0;  // half of what turning alone contributes to hi - lo; a hint
};

// How much a motion's parts move the separating-axis functions, summed over the active ones: along
// g1, along g2, by turning. A hint of which part to halve.
struct Sway {
  double g1 = 0.0;
  double g2 = 0.0;
  double turn = 0.0;
};

// The moving piece at the centre rotation of the motion.
struct PosedPiece {
  const ConvexPiece* piece;
  std::span<const Vec2> vertices;  // R(theta_c) a
  std::span<const Vec2> normals;   // R(theta_c) m
  Vec2 inner_centre;               // R(theta_c) c of the inner circle
};

enum class PairLabel : std::uint8_t {
  kApart,    // apart by the motion's margin (0: or touching) in every configuration: some axis
             // has lo >= margin + error
  kOverlap,  // overlapping in every configuration: every axis has hi < -error
  kUndecided,
};

struct PairVerdict {
  PairLabel label = PairLabel::kUndecided;
  double clearance = 0.0;  // kApart: certified lower bound of the separation
  double centre = 0.0;     // otherwise: max over axes of (lo + hi) / 2
  Sway sway;               // kUndecided
};

// Rounding bound of every value below: |computed - exact| <= separation_error.
inline double separation_error(const ConvexPiece& a, const ConvexPiece& b, const Motion& motion) {
  return (kSeparationErrorUnits * kUnitRoundoff + motion.angle_error) *
         (a.reach + b.reach + motion.reach);
}

// Range of v cos(delta) + w sin(delta) over |delta| <= half_angle (half_angle <= pi/2).
Range sinusoid_range(double v, double w, const Motion& motion);

// Range of one separating-axis function; narrows the constraint's vertex range to the possible
// minimisers. `error` is the pair's separation_error.
Range constraint_range(const PosedPiece& a, const ConvexPiece& b, const Motion& motion,
                       double error, Constraint& constraint);

// All separating-axis functions of a pair, with full vertex ranges.
void all_constraints(const ConvexPiece& a, const ConvexPiece& b, std::vector<Constraint>& out);

// Judges the pair over the motion from `active` constraints and appends those that remain active
// (hi >= -error) to `remaining`. Functions that were dropped for a larger motion can never
// separate the pair in a smaller one. `evaluations` counts axis functions evaluated.
PairVerdict judge_pair(const PosedPiece& a, const ConvexPiece& b, const Motion& motion,
                       std::span<const Constraint> active, std::vector<Constraint>& remaining,
                       std::uint64_t& evaluations);

}  // namespace pdg
