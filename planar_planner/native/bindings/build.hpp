// What this build of the core is, for `planar-planner --version` (planar_planner/build_details.py).
#pragma once

#include <nanobind/nanobind.h>

namespace bindings {

nanobind::dict build_info();

}  // namespace bindings
