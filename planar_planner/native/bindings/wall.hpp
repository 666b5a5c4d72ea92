// The wall of a proof of absence as numpy arrays (planar_planner/explain/cells.py).
#pragma once

#include <nanobind/nanobind.h>

#include <optional>

#include "planar_planner/native/planning/planner.hpp"

namespace bindings {

// The table of `cells` for the boxes and faces that separate the last query's start from its goal;
// nothing if the last answer is no separation, of the robot or of a disc in its place. `theta` is
// the one angle of a robot that may not turn.
std::optional<nanobind::dict> wall(planner::Planner& planner, double theta);

}  // namespace bindings
