// The generalized penetration distance for Python.
#include <nanobind/nanobind.h>
#include <nanobind/stl/shared_ptr.h>
#include <nanobind/stl/tuple.h>
#include <nanobind/stl/vector.h>

#include <chrono>
#include <cstddef>
#include <functional>
#include <tuple>
#include <vector>

#include "pdg/native/convex_sets/convex_set.hpp"
#include "pdg/native/penetration_distance/penetration_distance.hpp"
#include "subjects.hpp"

namespace nb = nanobind;
using namespace nb::literals;

namespace pdg::python {
namespace {

using Clock = std::chrono::steady_clock;
using Step = std::tuple<double, double, std::size_t>;

// Whether the time is over; every so often Python may handle a signal, so that Ctrl-C works.
class Watch {
 public:
  explicit Watch(const double seconds) : seconds_(seconds) {}

  bool over() {
    const Clock::time_point now = Clock::now();
    if (now - last_signals_ > std::chrono::milliseconds(50)) {
      last_signals_ = now;
      const nb::gil_scoped_acquire acquire;
      if (PyErr_CheckSignals() != 0) throw nb::python_error();
    }
    return std::chrono::duration<double>(now - start_).count() > seconds_;
  }

 private:
  double seconds_;
  Clock::time_point start_ = Clock::now();
  Clock::time_point last_signals_ = start_;
};

}  // namespace

void bind_distance(nb::module_& m) {
  m.def(
      "penetration_distance",
      [](const SetPointer& a, const SetPointer& q, const double absolute_gap,
         const double relative_gap, const std::size_t iterations, const std::size_t facets,
         const double seconds, const bool history) {
        if (a->dimension() != q->dimension()) {
          throw nb::value_error("the sets must have one dimension");
        }
        std::vector<Step> steps;
        PenetrationDistance d;
        {
          const nb::gil_scoped_release release;
          Watch watch(seconds);
          const auto note = [&](const DistanceStep& step) {
            steps.emplace_back(step.lower, step.upper, step.facets);
          };
          d = penetration_distance(
              *a, *q, {absolute_gap, relative_gap, iterations, facets},
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
      "a"_a, "q"_a, "absolute_gap"_a, "relative_gap"_a, "iterations"_a, "facets"_a, "seconds"_a,
      "history"_a);
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
