// Python bindings of the pdg core: arrays in, plain tuples out. The Python layer validates first.
#include <nanobind/nanobind.h>
#include <nanobind/ndarray.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/pair.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/tuple.h>

#include <cstdint>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "arrays.hpp"
#include "pdg/native/geometry/motion_bound.hpp"
#include "pdg/native/geometry/predicates.hpp"
#include "pdg/native/pieces/decompose.hpp"
#include "pdg/native/pieces/piece_set.hpp"
#include "pdg/native/pieces/validity.hpp"
#include "subjects.hpp"

namespace nb = nanobind;
using namespace nb::literals;

namespace pdg::python {
namespace {

void bind_piece_set(const nb::module_& m) {
  nb::class_<pdg::PieceSet>(m, "PieceSet", "Convex pieces of one body; immutable.")
      .def(
          "__init__",
          [](pdg::PieceSet* self, const Coords& coords, const Starts& ring_starts,
             const Starts& polygon_starts, const bool cover) {
            std::vector<pdg::Polygon> polygons = to_polygons(coords, ring_starts, polygon_starts);
            const nb::gil_scoped_release release;
            std::vector<pdg::ConvexPolygon> pieces;
            for (const pdg::Polygon& polygon : polygons) {
              for (pdg::ConvexPolygon& piece :
                   cover ? pdg::convex_pieces(polygon) : pdg::convex_partition(polygon)) {
                pieces.push_back(std::move(piece));
              }
            }
            pdg::PieceSet set = pdg::make_piece_set(std::move(pieces));
            set.outline = std::move(polygons);
            new (self) pdg::PieceSet(std::move(set));
          },
          "coords"_a, "ring_starts"_a, "polygon_starts"_a, "cover"_a)
      .def("__len__", [](const pdg::PieceSet& self) { return self.polygons.size(); })
      .def_ro("radius", &pdg::PieceSet::radius)
      .def("radii",
           [](const pdg::PieceSet& self) {
             nb::list radii;
             for (const double r : self.radii) radii.append(r);
             return nb::typed<nb::list, double>(radii);
           })
      .def("arrays", [](const pdg::PieceSet& self) {
        std::vector<double> coords;
        std::vector<std::uint32_t> starts{0};
        for (const pdg::ConvexPolygon& polygon : self.polygons) {
          for (const pdg::Vec2 v : polygon) coords.insert(coords.end(), {v.x, v.y});
          starts.push_back(static_cast<std::uint32_t>(coords.size() / 2));
        }
        const std::size_t rows = coords.size() / 2;
        const std::size_t count = starts.size();
        return std::pair{to_array<double, CoordsOut>(std::move(coords), {rows, 2}),
                         to_array<std::uint32_t, StartsOut>(std::move(starts), {count})};
      });
}

void bind_motions(nb::module_& m) {
  m.def(
      "motion_bounds",
      [](const Triple& half, const double radius) {
        const pdg::HalfExtents h = to_half_extents(half);
        return Triple{pdg::sum_bound(h, radius), pdg::arc_bound(h, radius),
                      pdg::displacement_bound(h, radius)};
      },
      "half"_a, "radius"_a);
}

// The polygon's index, what is wrong with it, and where, if there is such a place.
using FoundDefect = std::tuple<std::size_t, std::string, std::optional<Pair>>;

std::optional<FoundDefect> defect_of(const pdg::Polygon& polygon, const std::size_t index) {
  try {
    const std::optional<pdg::Defect> defect = pdg::find_defect(polygon);
    if (!defect) return std::nullopt;
    return FoundDefect{index, defect->what, to_pair(defect->where)};
  } catch (const std::invalid_argument& error) {
    return FoundDefect{index, error.what(), std::nullopt};
  }
}

void bind_validity(nb::module_& m) {
  m.def(
      "first_defect",
      [](const Coords& coords, const Starts& ring_starts,
         const Starts& polygon_starts) -> std::optional<FoundDefect> {
        const std::vector<pdg::Polygon> polygons = to_polygons(coords, ring_starts, polygon_starts);
        const nb::gil_scoped_release release;
        for (std::size_t p = 0; p < polygons.size(); ++p) {
          if (auto found = defect_of(polygons[p], p)) return found;
        }
        return std::nullopt;
      },
      "coords"_a, "ring_starts"_a, "polygon_starts"_a);
}

}  // namespace
}  // namespace pdg::python

NB_MODULE(_core, m) {  // NOLINT(bugprone-signed-bitwise): inside the macro
  // An object that the interpreter still holds when it ends is no fault worth a message.
  nanobind::set_leak_warnings(false);
  m.attr("MIN_COORDINATE") = pdg::kMinCoordinate;
  m.attr("MAX_COORDINATE") = pdg::kMaxCoordinate;
  pdg::python::bind_piece_set(m);
  pdg::python::bind_batches(m);
  pdg::python::bind_bracket(m);
  pdg::python::bind_depths(m);
  pdg::python::bind_upper_bounds(m);
  pdg::python::bind_motions(m);
  pdg::python::bind_validity(m);
  pdg::python::bind_sets(m);
  pdg::python::bind_grasp(m);
  pdg::python::bind_distance(m);
}
