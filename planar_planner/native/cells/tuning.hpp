// Heuristic constants of this folder, with how each was found. They steer work; whatever their
// values, labels and proofs hold.
#pragma once

#include "planar_planner/native/labels/classify.hpp"

namespace planner {

// Sways of at least this part of the largest count as comparable. 1 makes cells needlessly thin, 0
// forgets what the undecided functions depend on. Measured over the shipped families and gates.
inline constexpr double kComparable = 0.5;

// Cells whose motion radius is below this part of the robot's reach are asked which axis settles
// them. Larger: fewer cells yet, at more time a cell; 0.2 costs the shipped scenes no time.
// Measured.
inline constexpr double kAskBelow = 0.2;

// More cells are FULL by several pairs than STAR, and one whose centre looks free is not FULL.
inline constexpr Questions kCellQuestions{.settle_below = kAskBelow};

// Most faces between solid cells have a guard, so that is asked first. Only the rest are asked for
// joint obstruction, but all of them, since a face that is left undecided costs a cell.
inline constexpr Questions kFaceQuestions{.star_first = true, .joint_if_centre_looks_free = true};

// A face is halved at most so often, and at most so many parts are looked at, before one of its
// cells is split instead. Larger values trade cells for face tests. Chosen with the first search,
// not tuned since.
inline constexpr int kFaceDepth = 10;
inline constexpr int kFaceBudget = 48;

}  // namespace planner
