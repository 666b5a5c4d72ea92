// Binds the check of single configurations, for sampling planners and whoever asks often.
#pragma once

#include <nanobind/nanobind.h>
#include <nanobind/ndarray.h>
#include <nanobind/stl/array.h>

#include <array>
#include <memory>

#include "planar_planner/native/paths/state_check.hpp"
#include "planar_planner/native/planning/planner.hpp"

namespace bindings {

namespace nb = nanobind;
using Configurations = nb::ndarray<const double, nb::shape<-1, 3>, nb::c_contig, nb::device::cpu>;

inline nb::object are_free(planner::StateCheck& check, const Configurations& configurations) {
  const std::size_t count = configurations.shape(0);
  auto data = std::make_unique<bool[]>(count);
  // Under the GIL, since a check is not thread-safe.
  const double* q = configurations.data();
  for (std::size_t i = 0; i < count; ++i, q += 3) data[i] = check.is_free({q[0], q[1], q[2]});
  bool* const raw = data.get();
  nb::capsule owner(data.release(), [](void* p) noexcept {
    const std::unique_ptr<bool[]> reclaim(static_cast<bool*>(p));
  });
  return nb::ndarray<nb::numpy, bool, nb::ndim<1>>(raw, {count}, owner).cast();
}

// Adds the class StateCheck, made from a Core.
inline void add_state_check(nb::module_& m) {
  nb::class_<planner::StateCheck>(m, "StateCheck")
      .def(
          "__init__",
          [](planner::StateCheck* self, const planner::Planner& core) {
            new (self) planner::StateCheck(core.problem());
          },
          nb::arg("core"))
      // Unnamed arguments: the call is the whole cost of a check on an easy scene.
      .def("is_free", [](planner::StateCheck& self, const double x, const double y,
                         const double theta) { return self.is_free({x, y, theta}); })
      .def("are_free", &are_free, nb::arg("configurations"))
      .def_prop_ro("checks", &planner::StateCheck::checks)
      .def_prop_ro("bounds",
                   [](const planner::StateCheck& self) {
                     const planner::Rectangle r = self.bounds();
                     return std::array<double, 4>{r.low.x, r.low.y, r.high.x, r.high.y};
                   })
      .def_prop_ro("robot_radius", &planner::StateCheck::robot_radius);
}

}  // namespace bindings
