// Every rounding constant that only the planner needs, with unit and derivation in short; in full,
// term by term, in docs/rounding.md. Those of separating-axis functions, which it shares with the
// library, and the assumptions about arithmetic stand in pdg/native/tolerances.hpp. Three things
// are kept apart: rounding error (there and here), the user's resolution and the user's contact
// tolerance (options).
//
// u, A, B, T as there. Too small a value makes labels false; too large a one only stops the
// subdivision earlier.
#pragma once

#include "pdg/native/tolerances.hpp"

namespace planner {

// Error of a configuration's angle that was interpolated between two others, in units of u max
// |theta|: interpolation 5, waypoints' own rounding 1.4.
inline constexpr double kPoseAngleUnits = 8.0 * PDG_MARGIN_SCALE;

// A guard condition of the star test: at most 84 u (A + B + T) (of T; 26 of A, 32 of B), that is
// 1.5 separation errors.
inline constexpr double kGuardErrorFactor = 1.5;

// A weighted sum of up to four functions, per unit of weight: at most 97 u (A + B + T) (of T), that
// is less than 1.75 separation errors.
inline constexpr double kJointErrorFactor = 1.75;

// What the error bounds leave unused, in units of u times the domain's reach: of a separating-axis
// function 64 - 51, of a guard condition 96 - 84, of a weighted sum 112 - 97.
inline constexpr double kUnusedErrorUnits = 12.0;
// By how much robot, obstacle and end together move where each coordinate moves by 1: 3 sqrt(2).
inline constexpr double kMovedByCoordinates = 5.0;

// Radius of a disc about the robot's origin inside a piece, from its edges' offsets: 6 u of the
// largest |a|, and the subtraction.
inline constexpr double kInnerReachUnits = 8.0 * PDG_MARGIN_SCALE;

// Distance of the origin from the robot's hull, from the nearest points of edges: 5 u of the
// largest |a|; edges' offsets 6 u; and the sums that widen the domain by it.
inline constexpr double kHullDistanceUnits = 16.0 * PDG_MARGIN_SCALE;

// By how much the domain is grown on every side, in units of u times the planner's unit of length
// or its farthest coordinate, if that is more:
// rounding of the bounds (1), of corner and size (5).
inline constexpr double kDomainUnits = 8.0 * PDG_MARGIN_SCALE;

// A cell's corner in the user's units, in units of u times its own magnitude and that of the domain
// and its size: product and sum 1 each, frame 1, the sum that moves it outwards 1.
inline constexpr double kCornerUnits = 4.0 * PDG_MARGIN_SCALE;

// Where a point of the robot's frame is, in units of u times (|c|_1 + |x| + |y|, the larger of both
// places'): each coordinate has sine and cosine 1, products 1, their sum 1 of |c|_1 and the last
// sum 1 of the place; the distance is at most sqrt(2) times that, 4.3 and 1.5.
inline constexpr double kTurnedPointUnits = 8.0 * PDG_MARGIN_SCALE;

// Relative slack of |c| turn^2 / 8, in u: |c| 2, turn 1 and twice in the square, products 3.
inline constexpr double kArcUnits = 16.0 * PDG_MARGIN_SCALE;

// Relative slack of the discs that stand for a nearly round robot, in u: libm's cos (2), product
// and radii (3).
inline constexpr double kDiscUnits = 16.0;

// A vertex of the robot turned by quarter turns and moved, in u times the largest coordinate: the
// sum 2, the slack's own rounding 1.
inline constexpr double kRobotBoxUnits = 4.0;

// Pairs whose circles are this far apart (planner units) do not touch: far more than rounding, so
// that every pair that may touch is looked at, and no looser bound depends on it.
inline constexpr double kTouchingGap = 0x1p-20;

// By how much, in u relative to it, a way out of contact stays below the contact tolerance.
inline constexpr double kLiftOffUnits = 8.0;

}  // namespace planner
