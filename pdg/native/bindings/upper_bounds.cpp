// Upper bounds of PD^g for Python.
#include <nanobind/nanobind.h>
#include <nanobind/ndarray.h>
#include <nanobind/stl/tuple.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <tuple>
#include <utility>
#include <vector>

#include "arrays.hpp"
#include "pdg/native/bounds/convex_separators.hpp"
#include "pdg/native/bounds/depth_upper_bound.hpp"
#include "rows.hpp"
#include "separators.hpp"
#include "subjects.hpp"

namespace nb = nanobind;
using namespace nb::literals;

namespace pdg::python {
namespace {

using SideRows = nb::ndarray<nb::numpy, double, nb::shape<-1, 3>>;
using BoundRows = nb::ndarray<nb::numpy, double, nb::shape<-1, 8>>;
using BoundCodes = nb::ndarray<nb::numpy, std::int32_t, nb::shape<-1, 7>>;

std::array<double, 8> numbers_of(const pdg::DepthUpperBound& bound) {
  const pdg::Pose& p = bound.displaced.pose;
  const pdg::Pose& q = bound.distanced.pose;
  return {bound.displacement, p.t.x, p.t.y, p.theta, bound.distance, q.t.x, q.t.y, q.theta};
}

std::array<std::int32_t, 7> codes_of(const pdg::DepthUpperBound& bound) {
  const pdg::FreePlacement& p = bound.displaced;
  const pdg::FreePlacement& q = bound.distanced;
  return {static_cast<std::int32_t>(p.source),
          p.separator,
          p.drawn_back ? 1 : 0,
          static_cast<std::int32_t>(q.source),
          q.separator,
          q.drawn_back ? 1 : 0,
          bound.placements};
}

// Without separators the bound is that of the convex hulls alone; `draw_back` needs separators.
auto upper_bounds(const pdg::PieceSet& a, const pdg::PieceSet& b, const SeparatorSet* separators,
                  const Poses& poses, const bool draw_back) {
  const std::size_t count = poses.shape(0);
  std::vector<double> numbers(8 * count);
  std::vector<std::int32_t> codes(7 * count);
  pdg::UpperBoundScratch scratch;
  const std::int64_t bad = for_each_row(count, [&](const std::size_t row) {
    const pdg::Pose pose = pose_of(poses, row);
    const pdg::DepthUpperBound bound =
        separators == nullptr ? pdg::hull_upper_bound(a, b, pose, scratch)
        : draw_back ? pdg::drawn_back_upper_bound(a, b, separators->separators, pose, scratch)
                    : pdg::separator_upper_bound(a, b, separators->separators, pose, scratch);
    const auto n = numbers_of(bound);
    const auto c = codes_of(bound);
    std::copy(n.begin(), n.end(), numbers.begin() + static_cast<std::ptrdiff_t>(8 * row));
    std::copy(c.begin(), c.end(), codes.begin() + static_cast<std::ptrdiff_t>(7 * row));
  });
  return std::tuple{bad, to_array<double, BoundRows>(std::move(numbers), {count, 8}),
                    to_array<std::int32_t, BoundCodes>(std::move(codes), {count, 7})};
}

}  // namespace

void bind_upper_bounds(nb::module_& m) {
  nb::class_<SeparatorSet>(m, "SeparatorSet", "Convex separators of one body; immutable.")
      .def(
          "__init__",
          [](SeparatorSet* self, const pdg::PieceSet& body) {
            const nb::gil_scoped_release release;
            new (self) SeparatorSet{pdg::convex_separators(body)};
          },
          "body"_a)
      .def("__len__", [](const SeparatorSet& self) { return self.separators.size(); })
      .def(
          "sides",
          [](const SeparatorSet& self, const std::size_t index) {
            std::vector<double> rows;
            for (const pdg::HalfPlane& side : self.separators.at(index).sides) {
              rows.insert(rows.end(), {side.normal.x, side.normal.y, side.offset});
            }
            const std::size_t count = rows.size() / 3;
            return to_array<double, SideRows>(std::move(rows), {count, 3});
          },
          "index"_a);
  m.def("depth_upper_bounds", &upper_bounds, "a"_a, "b"_a, "separators"_a.none(), "poses"_a,
        "draw_back"_a);
}

}  // namespace pdg::python
