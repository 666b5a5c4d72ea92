// The generalized penetration distance for Python.
#include <nanobind/nanobind.h>
#include <nanobind/stl/shared_ptr.h>
#include <nanobind/stl/tuple.h>
#include <nanobind/stl/vector.h>

#include <cstddef>
#include <functional>
#include <tuple>
#include <vector>

#include "pdg/native/convex_sets/convex_set.hpp"
#include "pdg/native/penetration_distance/penetration_distance.hpp"
#include "subjects.hpp"
#include "watch.hpp"

namespace nb = nanobind;
using namespace nb::literals;

namespace pdg::python {
namespace {

using Step = std::tuple<double, double, std::size_t>;

}  // namespace

void bind_distance(nb::module_& m) {
  m.def(
      "penetration_distance",
      [](const SetPointer& a, const SetPointer& q, const double absolute_tolerance,
         const double relative_tolerance, const std::size_t max_iterations,
         const std::size_t max_facets, const double timeout, const bool history) {
        if (a->dimension() != q->dimension()) {
          throw nb::value_error("the sets must have one dimension");
        }
        std::vector<Step> steps;
        PenetrationDistance d;
        {
          const nb::gil_scoped_release release;
          Watch watch(timeout);
          const auto note = [&](const DistanceStep& step) {
            steps.emplace_back(step.lower, step.upper, step.facets);
          };
          d = penetration_distance(
              *a, *q, {absolute_tolerance, relative_tolerance, max_iterations, max_facets},
              [&] { return watch.over(); },
              history ? std::function<void(const DistanceStep&)>(note) : nullptr);
        }
        return std::tuple{static_cast<int>(d.state),
                          static_cast<int>(d.reason),
                          d.lower,
                          d.upper,
                          d.direction,
                          d.point,
                          d.iterations,
                          d.facets,
                          steps};
      },
      "a"_a, "q"_a, "absolute_tolerance"_a, "relative_tolerance"_a, "max_iterations"_a,
      "max_facets"_a, "timeout"_a, "history"_a);
  m.def(
      "upper_bound_along",
      [](const SetPointer& a, const SetPointer& q, const std::vector<double>& u) {
        if (u.size() != a->dimension() || u.size() != q->dimension()) {
          throw nb::value_error("the sets and the direction must have one dimension");
        }
        return upper_bound_along(*a, *q, u);
      },
      "a"_a, "q"_a, "u"_a);
}

}  // namespace pdg::python
