// The leaves of the subdivision as numpy arrays (planar_planner/cells.py).
#pragma once

#include <nanobind/nanobind.h>

#include "planner.hpp"

namespace bindings {

nanobind::dict cells(const planner::Planner& planner);

}  // namespace bindings
