// Each file of bindings binds one subject; module.cpp calls each of these functions once.
#pragma once

#include <nanobind/nanobind.h>

namespace pdg::python {

void bind_batches(nanobind::module_& m);
void bind_bracket(nanobind::module_& m);
void bind_depths(nanobind::module_& m);
void bind_distance(nanobind::module_& m);
void bind_grasp(nanobind::module_& m);
void bind_sets(nanobind::module_& m);
void bind_upper_bounds(nanobind::module_& m);

}  // namespace pdg::python
