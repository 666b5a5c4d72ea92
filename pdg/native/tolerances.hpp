// Every rounding constant of the library, with unit and derivation. Three things are kept apart:
// rounding error (here), the user's resolution and the user's contact tolerance (options).
//
// Assumptions: IEEE 754 doubles, + - * / sqrt correctly rounded, no contraction
// (-ffp-contract=off), libm sin and cos within 1 ulp.
#pragma once

#include <limits>

namespace pdg {

// Unit roundoff u: |fl(x op y) - (x op y)| <= u |x op y|.
inline constexpr double kUnitRoundoff = std::numeric_limits<double>::epsilon() / 2;

// Forward error of every separating-axis function, and of its range over a motion, in units of
// u * (|a| + |b| + |t|), where |a|, |b|, |t| bound the robot vertices, the obstacle vertices and
// the translations (all in the evaluation frame). First-order terms, in units of u:
//   rotated vertex R a          6 |a|   (cos, sin: 3 each with the argument's rounding; products 3)
//   rotated normal R m         10       (the normal itself: 4)
//   obstacle edge, v and w     12 |a|   (R a: 6, normal: 4, dot product: 2)
//     v cos h + |w| sin h      23 |a|   (sqrt(2) (12 + 4))
//     n . t_c                   8 |t|,  box extent 14 |t|, offset d 7 |b|, sums 4 (|a|+|b|+|t|)
//     another vertex of B beyond the rounded normal: 8 |b| (4 u times the diameter)
//   robot edge, v and w        15 (|b|+|t|)  (u_b = b - t_c: 3, normal: 10, dot product: 2)
//     v cos h + |w| sin h      27 (|b|+|t|), box extent 32 |t|, offset c 7 |a|, sums 5,
//     another vertex of A beyond the rounded normal: 20 |a|
//   vertices dropped as no minimiser on the strength of rounded values: twice 27 (|b|+|t|)
// The largest coefficient is 27 + 32 + 5 + 8 + 54 = 126 (of |t|). Second-order terms and the guard
// conditions of the star test, which add at most 16 to it, fit below 160.
// Too small a value makes labels false; too large a one only stops the subdivision earlier.
inline constexpr double kSeparationErrorUnits = 160.0;

// Slack, in the sine of an angle, with which an edge counts as aligned with a direction within a
// half-angle: two unit normals of error 10 u each, a cross product (3 u) and sin h (2 u), doubled.
// Counting one edge too many only loosens an upper bound.
inline constexpr double kAlignmentSlack = 50.0 * kUnitRoundoff;

// Relative padding that turns a computed radius or extent (a few roundings, at most 16 u) into an
// upper bound.
inline constexpr double kRadiusPadding = 1.0 + 32.0 * kUnitRoundoff;

}  // namespace pdg
