// A robot that is nearly a disc about its reference point hardly needs theta. A polygon round it in
// every orientation that finds a way by translation alone gives a path; a polygon inside it in
// every orientation that has none proves that there is none.
#pragma once

#include <optional>

#include "problem.hpp"
#include "scaled_problem.hpp"

namespace planner {

// The problem with a regular polygon that may not turn for a robot.
struct DiscProblems {
  Problem
      round;  // holds the robot in every orientation, up to rounding: its path is certified again
  Problem inside;  // lies inside the robot in every orientation, exactly
};

// Empty unless the robot's discs are so close to it that they are worth a try.
std::optional<DiscProblems> disc_problems(const ScaledProblem& problem);

}  // namespace planner
