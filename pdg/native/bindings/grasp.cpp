// Grasp wrench sets for Python.
#include <nanobind/nanobind.h>
#include <nanobind/ndarray.h>
#include <nanobind/stl/shared_ptr.h>

#include <vector>

#include "pdg/native/convex_sets/grasp_wrench_set.hpp"
#include "subjects.hpp"

namespace nb = nanobind;
using namespace nb::literals;

namespace pdg::python {
namespace {

// Shape (contacts, 1 + axes, dimension): the rows of a contact are its centre, then its axes.
using Columns = nb::ndarray<const double, nb::shape<-1, -1, -1>, nb::c_contig, nb::device::cpu>;

}  // namespace

void bind_grasp(nb::module_& m) {
  m.def(
      "grasp_wrench_set",
      [](const Columns& columns, const bool largest, const bool idle) {
        if (columns.shape(1) == 0) throw nb::value_error("a contact needs a centre");
        return grasp_wrench_set({columns.shape(0),
                                 columns.shape(2),
                                 columns.shape(1) - 1,
                                 {columns.data(), columns.data() + columns.size()}},
                                largest ? ForceNorm::kLargest : ForceNorm::kSum, idle);
      },
      "columns"_a, "largest"_a, "idle"_a);
}

}  // namespace pdg::python
