// Depths and the C-obstacle query for Python.
#include <nanobind/nanobind.h>
#include <nanobind/stl/pair.h>
#include <nanobind/stl/tuple.h>

#include <tuple>

#include "arrays.hpp"
#include "pdg/native/depth/generalized_depth.hpp"
#include "pdg/native/depth/nonconvex_depth.hpp"
#include "pdg/native/separation/c_obstacle_query.hpp"
#include "subjects.hpp"

namespace nb = nanobind;
using namespace nb::literals;

namespace pdg::python {

void bind_depths(nb::module_& m) {
  m.def(
      "translational_depth",
      [](const pdg::PieceSet& a, const pdg::PieceSet& b, const Triple& pose) {
        const nb::gil_scoped_release release;
        return to_tuple(pdg::translational_depth(a, b, to_pose(pose)));
      },
      "a"_a, "b"_a, "pose"_a);
  m.def(
      "generalized_depth_lower_bound",
      [](const pdg::PieceSet& a, const pdg::PieceSet& b, const Triple& pose) {
        const pdg::DepthLowerBound bound = pdg::generalized_depth_lower_bound(a, b, to_pose(pose));
        return std::tuple{bound.depth, bound.piece_a, bound.piece_b, to_tuple(bound.pair)};
      },
      "a"_a, "b"_a, "pose"_a);
  m.def(
      "c_obstacle_query",
      [](const pdg::PieceSet& a, const pdg::PieceSet& b, const Triple& centre, const Triple& half,
         const int method) {
        const pdg::CObstacleVerdict verdict = pdg::c_obstacle_query(
            a, b, {to_pose(centre), to_half_extents(half)}, static_cast<pdg::QueryMethod>(method));
        return std::tuple{verdict.full, verdict.piece_a, verdict.piece_b, verdict.margin};
      },
      "a"_a, "b"_a, "centre"_a, "half"_a, "method"_a);
}

}  // namespace pdg::python
