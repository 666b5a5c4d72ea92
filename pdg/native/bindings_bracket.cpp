// Brackets of the generalized depth for Python.
#include <nanobind/nanobind.h>
#include <nanobind/stl/pair.h>
#include <nanobind/stl/tuple.h>

#include <chrono>
#include <cstdint>
#include <tuple>
#include <utility>

#include "bindings_arrays.hpp"
#include "bindings_separators.hpp"
#include "bindings_subjects.hpp"
#include "bracket.hpp"

namespace nb = nanobind;
using namespace nb::literals;

namespace pdg::python {
namespace {

using Clock = std::chrono::steady_clock;

// Without the interpreter's lock; looks at the clock and at signals between nodes.
auto bracket_depth(const pdg::PieceSet& a, const pdg::PieceSet& b, const SeparatorSet* separators,
                   const Triple& pose, const double rel_tol, const double seconds,
                   const std::uint64_t nodes) {
  constexpr std::uint64_t kNodesBetweenSignals = 256;
  const Clock::time_point begin = Clock::now();
  std::uint64_t asked = 0;
  pdg::BracketLimits limits{rel_tol, nodes, {}};
  limits.stop = [&] {
    if (++asked % kNodesBetweenSignals == 0) {
      const nb::gil_scoped_acquire acquire;
      if (PyErr_CheckSignals() != 0) throw nb::python_error();
    }
    return std::chrono::duration<double>(Clock::now() - begin).count() >= seconds;
  };
  const nb::gil_scoped_release release;
  const pdg::Bracket found = separators == nullptr ? pdg::bracket_depth(a, b, to_pose(pose), limits)
                                                   : pdg::bracket_depth(a, b, to_pose(pose), limits,
                                                                        separators->separators);
  const auto triple = [](const pdg::Pose& q) { return Triple{q.t.x, q.t.y, q.theta}; };
  return std::tuple{found.lower,
                    std::pair{found.displaced.displacement, triple(found.displaced.pose)},
                    std::pair{found.distanced.distance, triple(found.distanced.pose)},
                    found.nodes,
                    found.slices,
                    static_cast<int>(found.end)};
}

}  // namespace

void bind_bracket(nb::module_& m) {
  m.def("bracket_depth", &bracket_depth, "a"_a, "b"_a, "separators"_a.none(), "pose"_a, "rel_tol"_a,
        "seconds"_a, "nodes"_a);
}

}  // namespace pdg::python
