// Convex sets for Python, and Python objects as convex sets.
#include <nanobind/nanobind.h>
#include <nanobind/ndarray.h>
#include <nanobind/stl/pair.h>
#include <nanobind/stl/shared_ptr.h>
#include <nanobind/stl/vector.h>

#include <cmath>
#include <cstddef>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "arrays.hpp"
#include "pdg/native/convex_sets/convex_bodies.hpp"
#include "pdg/native/convex_sets/convex_composites.hpp"
#include "pdg/native/convex_sets/convex_set.hpp"
#include "subjects.hpp"

namespace nb = nanobind;
using namespace nb::literals;

namespace pdg::python {
namespace {

using Vector = nb::ndarray<const double, nb::shape<-1>, nb::c_contig, nb::device::cpu>;
using Rows = nb::ndarray<const double, nb::shape<-1, -1>, nb::c_contig, nb::device::cpu>;
using VectorOut = nb::ndarray<nb::numpy, double, nb::shape<-1>>;
using RowsOut = nb::ndarray<nb::numpy, double, nb::shape<-1, -1>>;

std::vector<double> to_vector(const Vector& v) {
  return {v.data(), v.data() + v.size()};
}

Matrix to_matrix(const Rows& m) {
  return {m.shape(0), m.shape(1), {m.data(), m.data() + m.size()}};
}

// A set that asks a Python callable u -> (h(u), s(u)), whose answers its Python side checks. Each
// question takes the interpreter's lock, which is slow.
class PythonSet final : public ConvexSet {
 public:
  PythonSet(nb::callable support, std::vector<double> magnitude, std::vector<double> error)
      : ConvexSet(std::move(magnitude), std::move(error)), support_(std::move(support)) {}

  [[nodiscard]] double value(const std::span<const double> u) const override {
    std::vector<double> point(u.size());
    return add_support(u, point);
  }

  double add_support(const std::span<const double> u,
                     const std::span<double> point) const override {
    const nb::gil_scoped_acquire acquire;
    const std::size_t n = u.size();
    const nb::object answer =
        support_(to_array<double, VectorOut>(std::vector<double>(u.begin(), u.end()), {n}));
    const auto at = nb::cast<std::vector<double>>(answer[1]);
    if (at.size() != n) throw nb::value_error("a support point has the wrong size");
    for (std::size_t i = 0; i < n; ++i) point[i] += at[i];
    return nb::cast<double>(answer[0]);
  }

 private:
  nb::callable support_;
};

std::pair<VectorOut, RowsOut> supports(const ConvexSet& set, const Rows& directions) {
  const std::size_t count = directions.shape(0);
  const std::size_t n = directions.shape(1);
  if (n != set.dimension()) throw nb::value_error("directions of the wrong dimension");
  std::vector<double> values(count);
  std::vector<double> points(count * n);
  for (std::size_t k = 0; k < count; ++k) {
    values[k] =
        support(set, std::span(directions.data() + k * n, n), std::span(points).subspan(k * n, n));
  }
  return {to_array<double, VectorOut>(std::move(values), {count}),
          to_array<double, RowsOut>(std::move(points), {count, n})};
}

}  // namespace

void bind_sets(nb::module_& m) {
  nb::class_<ConvexSet>(m, "ConvexSet", "A convex set by its support function; immutable.")
      .def_prop_ro("dimension", &ConvexSet::dimension)
      .def("magnitude",
           [](const ConvexSet& set) {
             return std::vector<double>(set.magnitude().begin(), set.magnitude().end());
           })
      .def("error",
           [](const ConvexSet& set) {
             return std::vector<double>(set.error().begin(), set.error().end());
           })
      .def("supports", &supports, "directions"_a);
  m.def(
      "axis_ellipsoid",
      [](const Vector& radii, const Vector& centre) {
        return axis_ellipsoid(to_vector(radii), to_vector(centre));
      },
      "radii"_a, "centre"_a);
  m.def(
      "ellipsoid",
      [](const Rows& axes, const Vector& centre) {
        return ellipsoid(to_matrix(axes), to_vector(centre));
      },
      "axes"_a, "centre"_a);
  m.def(
      "box",
      [](const Vector& half_extents, const Vector& centre) {
        return box(to_vector(half_extents), to_vector(centre));
      },
      "half_extents"_a, "centre"_a);
  m.def(
      "cross_polytope",
      [](const Vector& radii, const Vector& centre) {
        return cross_polytope(to_vector(radii), to_vector(centre));
      },
      "radii"_a, "centre"_a);
  m.def("point_set", [](const Rows& points) { return point_set(to_matrix(points)); }, "points"_a);
  m.def("minkowski_sum", &minkowski_sum, "sets"_a);
  m.def("union_hull", &union_hull, "sets"_a);
  m.def(
      "affine_image",
      [](const Rows& map, const Vector& offset, SetPointer set) {
        return affine_image(to_matrix(map), to_vector(offset), std::move(set));
      },
      "map"_a, "offset"_a, "set"_a);
  m.def(
      "stretched",
      [](const Vector& factors, SetPointer set) {
        return stretched(to_vector(factors), std::move(set));
      },
      "factors"_a, "set"_a);
  m.def("scaled", &scaled, "factor"_a, "set"_a);
  m.def(
      "python_set",
      [](nb::callable support, std::vector<double> magnitude,
         std::vector<double> error) -> SetPointer {
        return std::make_shared<PythonSet>(std::move(support), std::move(magnitude),
                                           std::move(error));
      },
      "support"_a, "magnitude"_a, "error"_a);
}

}  // namespace pdg::python
