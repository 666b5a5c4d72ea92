// Statistics and Seconds as Python classes, made from the lists of statistics.hpp.
#pragma once

#include <nanobind/nanobind.h>

namespace bindings {

// Adds both classes; DecidedBy must have been added.
void add_statistics(nanobind::module_& m);

}  // namespace bindings
