// The leaves of the subdivision, and where its wall is thinnest, as numpy arrays
// (planar_planner/cells.py, planar_planner/bottleneck.py).
#pragma once

#include <nanobind/nanobind.h>

#include "planar_planner/native/planning/planner.hpp"

namespace bindings {

nanobind::dict cells(const planner::Planner& planner);
// "way", "depth" and "deepest" of planner::Crossing.
nanobind::dict bottleneck(planner::Planner& planner);

}  // namespace bindings
