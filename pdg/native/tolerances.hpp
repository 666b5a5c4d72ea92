// Every rounding constant of the library, with unit and derivation in short; in full, term by term,
// in docs/rounding.md. Rounding error is one thing; the tolerances that a caller asks for are
// another, and are arguments.
//
// Assumptions: IEEE 754 doubles rounded to nearest, + - * / sqrt correctly rounded, no contraction
// (-ffp-contract=off), libm sin, cos and hypot within 1 ulp, magnitudes as the gates admit them.
//
// Too small a value makes labels false; too large a one only stops the subdivision earlier.
// A, B, T: bounds of |a|, |b|, |t|, where a is a robot vertex, b an obstacle vertex and t a
// translation of the motion, all in the frame of evaluation.
#pragma once

#include <limits>

// The rounding tests build the core once more with 0: without its margins it must be caught lying.
#ifndef PDG_MARGIN_SCALE
#define PDG_MARGIN_SCALE 1.0
#endif

namespace pdg {

// Unit roundoff u: |fl(x op y) - (x op y)| <= u |x op y|.
inline constexpr double kUnitRoundoff = std::numeric_limits<double>::epsilon() / 2;

// Forward error of every separating-axis function, of its range over a motion, and of the distances
// between bounding circles and boxes, in units of u (A + B + T). Largest coefficients derived, over
// cells, faces, single configurations and segments: 23 (of A), 27 (of B), 51 (of T).
inline constexpr double kSeparationErrorUnits = 64.0 * PDG_MARGIN_SCALE;

// Largest half-angle (radians) at which a segment's turning is expanded about its middle: beyond
// it the expansion's error would exceed the bound above, and its slack is of no use.
inline constexpr double kWidestCoupledTurn = 0.5;

// Slack, in the sine of an angle, with which an edge counts as aligned with a direction within a
// half-angle: normals 4 and 10 u, cross product 2 u, sin h 2 u. Counting one edge too many only
// loosens an upper bound.
inline constexpr double kAlignmentSlack = 32.0 * kUnitRoundoff;

// Relative padding that turns a computed radius, extent or bound of motion (a few roundings of
// nonnegative terms, at most 16 u) into an upper bound.
inline constexpr double kRadiusPadding = 1.0 + 32.0 * PDG_MARGIN_SCALE * kUnitRoundoff;

// Rounding of a vertex on its way into the frame of evaluation (1 u of its magnitude) and of the
// sums that widen bounds by it, in units of u times the largest coordinate.
inline constexpr double kVertexUnits = 4.0 * PDG_MARGIN_SCALE;

// Centres of the stretches that a wide cell is cut into, in units of u (|theta| + half-angle).
inline constexpr double kStretchUnits = 8.0 * PDG_MARGIN_SCALE;

// A half-plane of a Minkowski sum at one angle, and a point against it, in units of u (A + B + T),
// coordinates from the slice's own origin, whose own magnitude counts towards A, B and T:
// at most 30 of A, 29 of B, 31 of T, where an edge of one body turns until it faces one of the
// other.
inline constexpr double kSliceErrorUnits = 32.0 * PDG_MARGIN_SCALE;

// Middle of a range of turns, in units of u (|middle| + half-angle): the first product 1, at most
// 46 halvings 1 each. Else gaps as wide would stay between ranges.
inline constexpr double kRangeMiddleUnits = 64.0 * PDG_MARGIN_SCALE;

// A separating-axis function of two polygons as placed, in units of u times the diameter of both
// together: normal 4, difference 1, product 2.
inline constexpr double kAxisErrorUnits = 8.0;
// The distance of a vertex from an edge, likewise: foot 11, difference 1, length 2.
inline constexpr double kGapErrorUnits = 16.0;

// Angle between two poses modulo full turns, in units of u (1 + |theta0| + |theta1|): difference 1,
// the full turns' own rounding 0.4.
inline constexpr double kTurnErrorUnits = 4.0;

// Errors of results; no label leans on these, the bracket of PD^g and the bounds of D_g do. PD^t of
// two polygons as placed, in units of u relative to it: area 10, length of the edge 3, quotient 1;
// the distance of disjoint polygons likewise. PD^t of pieces as given, in units of u times the
// diameter of both together and their frames' origins: placing 5 of A and 1 of T, depth 14 of
// A + B. The displacement of a body: in units of u (|t0| + |t1| + r (1 + |theta0| + |theta1|)), r
// the body's largest radius: 10 of r, 4 of t.
inline constexpr double kRelativeDepthErrorUnits = 16.0;
inline constexpr double kDepthErrorUnits = 12.0;
inline constexpr double kDisplacementErrorUnits = 16.0;

// Rounding of a support point and a support value, in units of u times the set's magnitude, beside
// 2 for each of its terms: products and sums over the terms (terms + 1, twice for a matrix and its
// transpose), square root of a sum of squares (terms / 2 + 2), quotient, centre (2). docs/
// penetration-distance.md, "Rounding".
inline constexpr double kSupportErrorUnits = 10.0 * PDG_MARGIN_SCALE;

// Relative padding of computed sums of up to 2^20 nonnegative products of bounds.
inline constexpr double kSumPadding = 1.0 + 0x1p-30 * PDG_MARGIN_SCALE;

// A bound that is a quotient of padded terms: a sum over it and one under it, the division, and the
// product that pads it: 4, relative.
inline constexpr double kQuotientErrorUnits = 8.0 * PDG_MARGIN_SCALE;

// A facet's plane is a convex combination of two others and moves off its vertices by at most this
// many times the rounding of one evaluation of a plane: coefficients 2, combination 1, heights 2 at
// the new point (simplicial_hull.hpp).
inline constexpr double kPlaneDriftUnits = 8.0;

// A point sees a facet of a simplicial hull if it is above its plane by more than this, in units of
// the plane's distance from a point inside. The lower bound holds for any value; a smaller one
// makes many more facets of coplanar points, a larger one ends convergence earlier.
inline constexpr double kSeenHeight = 0x1p-40;

// A pivot of Cholesky's method for points' inner products (scaled to at most 2) counts as zero
// below this, in units of u times the number of points. Deciding either way only changes where a
// search starts.
inline constexpr double kSingularPivotUnits = 16.0;

// How close, relative to the bound, branch and bound over the angle comes to the least DISP at
// which a container is entered: what is documented as one part in a thousand. No bound depends on
// it; halving it costs one more level of angles.
inline constexpr double kContainmentTolerance = 0x1p-10;
// Steps of the local search that follows, as motion of a body point relative to the bound. Branch
// and bound leaves the best angle off by its tolerance where DISP has a kink, by the square root of
// it, 2^-5, where DISP is smooth; the first step lies between, and is repeated as long as it helps.
// Steps below the square root of u (2^-26) no longer change a smooth minimum; the last leaves room
// for flat kinks.
inline constexpr double kFirstTurnStep = 0x1p-7;
inline constexpr double kLastTurnStep = 0x1p-30;

}  // namespace pdg
