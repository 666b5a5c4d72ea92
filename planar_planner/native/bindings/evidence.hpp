// The evidence of the last answer as plain Python values (planar_planner/certificate.py).
#pragma once

#include <nanobind/nanobind.h>

#include "planar_planner/native/planning/planner.hpp"

namespace bindings {

nanobind::dict evidence(planner::Planner& planner);

}  // namespace bindings
