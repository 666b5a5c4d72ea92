// Python bindings of the pdg core: arrays in, plain tuples out. The Python layer validates first.
#include <nanobind/nanobind.h>
#include <nanobind/ndarray.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/pair.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/tuple.h>

#include <array>
#include <cstdint>
#include <cstdio>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "c_obstacle_query.hpp"
#include "decompose.hpp"
#include "displacement.hpp"
#include "generalized_depth.hpp"
#include "motion_bound.hpp"
#include "piece_set.hpp"
#include "predicates.hpp"
#include "translational_depth.hpp"
#include "validity.hpp"

namespace nb = nanobind;
using namespace nb::literals;

namespace {

using Coords = nb::ndarray<const double, nb::shape<-1, 2>, nb::c_contig, nb::device::cpu>;
using Starts = nb::ndarray<const std::uint32_t, nb::shape<-1>, nb::c_contig, nb::device::cpu>;
using CoordsOut = nb::ndarray<nb::numpy, double, nb::shape<-1, 2>>;
using StartsOut = nb::ndarray<nb::numpy, std::uint32_t, nb::shape<-1>>;
using Pair = std::pair<double, double>;
using Triple = std::tuple<double, double, double>;
using DepthTuple = std::tuple<int, double, Pair, Pair, Pair>;

pdg::Pose to_pose(const Triple& q) {
  return {{std::get<0>(q), std::get<1>(q)}, std::get<2>(q)};
}

pdg::HalfExtents to_half_extents(const Triple& h) {
  return {std::get<0>(h), std::get<1>(h), std::get<2>(h)};
}

Pair to_pair(const pdg::Vec2 v) {
  return {v.x, v.y};
}

DepthTuple to_tuple(const pdg::TranslationalDepth& d) {
  return {static_cast<int>(d.state), d.depth, to_pair(d.direction), to_pair(d.on_a),
          to_pair(d.on_b)};
}

// Ring r is coords[ring_starts[r] : ring_starts[r + 1]], polygon p has the rings
// polygon_starts[p] : polygon_starts[p + 1], the outer one first.
std::vector<pdg::Polygon> to_polygons(const Coords& coords, const Starts& ring_starts,
                                      const Starts& polygon_starts) {
  const auto monotone_to = [](const Starts& starts, const std::size_t end) {
    if (starts.size() == 0 || starts(0) != 0 || starts(starts.size() - 1) != end) return false;
    for (std::size_t i = 1; i < starts.size(); ++i) {
      if (starts(i) < starts(i - 1)) return false;
    }
    return true;
  };
  if (!monotone_to(ring_starts, coords.shape(0)) ||
      !monotone_to(polygon_starts, ring_starts.size() - 1)) {
    throw nb::value_error("ring or polygon starts do not match the coordinates");
  }
  std::vector<pdg::Polygon> polygons(polygon_starts.size() - 1);
  for (std::size_t p = 0; p < polygons.size(); ++p) {
    for (std::size_t r = polygon_starts(p); r < polygon_starts(p + 1); ++r) {
      pdg::Ring& ring = polygons[p].rings.emplace_back();
      for (std::size_t i = ring_starts(r); i < ring_starts(r + 1); ++i) {
        ring.push_back({coords(i, 0), coords(i, 1)});
      }
    }
  }
  return polygons;
}

template <class Value, class Array>
Array to_array(std::vector<Value>&& values, const std::initializer_list<std::size_t> shape) {
  auto owned = std::make_unique<std::vector<Value>>(std::move(values));
  Value* data = owned->data();
  const nb::capsule owner(owned.release(), [](void* p) noexcept {
    const std::unique_ptr<std::vector<Value>> release(static_cast<std::vector<Value>*>(p));
  });
  return Array(data, shape, owner);
}

void bind_piece_set(const nb::module_& m) {
  nb::class_<pdg::PieceSet>(m, "PieceSet", "Convex pieces of one body; immutable.")
      .def(
          "__init__",
          [](pdg::PieceSet* self, const Coords& coords, const Starts& ring_starts,
             const Starts& polygon_starts, const bool cover) {
            const std::vector<pdg::Polygon> polygons =
                to_polygons(coords, ring_starts, polygon_starts);
            const nb::gil_scoped_release release;
            std::vector<pdg::ConvexPolygon> pieces;
            for (const pdg::Polygon& polygon : polygons) {
              for (pdg::ConvexPolygon& piece :
                   cover ? pdg::convex_pieces(polygon) : pdg::convex_partition(polygon)) {
                pieces.push_back(std::move(piece));
              }
            }
            new (self) pdg::PieceSet(pdg::make_piece_set(std::move(pieces)));
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

void bind_depths(nb::module_& m) {
  m.def(
      "translational_depth",
      [](const pdg::PieceSet& a, const pdg::PieceSet& b, const Triple& pose) {
        if (a.polygons.size() != 1 || b.polygons.size() != 1) {
          throw nb::value_error("translational_depth needs one convex piece each");
        }
        return to_tuple(
            pdg::translational_depth(pdg::placed(a.polygons[0], to_pose(pose)), b.polygons[0]));
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

void bind_motions(nb::module_& m) {
  m.def(
      "displacement",
      [](const pdg::PieceSet& body, const Triple& from, const Triple& to) {
        return pdg::displacement(body, to_pose(from), to_pose(to));
      },
      "body"_a, "q0"_a, "q1"_a);
  m.def(
      "generalized_distance_bounds",
      [](const pdg::PieceSet& body, const Triple& from, const Triple& to) {
        const auto bounds = pdg::generalized_distance_bounds(body, to_pose(from), to_pose(to));
        return Pair{bounds.lower, bounds.upper};
      },
      "body"_a, "q0"_a, "q1"_a);
  m.def(
      "motion_bounds",
      [](const Triple& half, const double radius) {
        const pdg::HalfExtents h = to_half_extents(half);
        return Triple{pdg::sum_bound(h, radius), pdg::arc_bound(h, radius),
                      pdg::displacement_bound(h, radius)};
      },
      "half"_a, "radius"_a);
}

// What is wrong with a polygon and where, if anything is.
std::optional<std::string> complaint(const pdg::Polygon& polygon) {
  try {
    const std::optional<pdg::Defect> defect = pdg::find_defect(polygon);
    if (!defect) return std::nullopt;
    std::array<char, 64> place{};
    std::snprintf(place.data(), place.size(), " at (%.15g, %.15g)", defect->where.x,
                  defect->where.y);
    return defect->what + std::string(place.data());
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
}

void bind_validity(nb::module_& m) {
  m.def(
      "first_defect",
      [](const Coords& coords, const Starts& ring_starts,
         const Starts& polygon_starts) -> std::optional<std::tuple<std::size_t, std::string>> {
        const std::vector<pdg::Polygon> polygons = to_polygons(coords, ring_starts, polygon_starts);
        const nb::gil_scoped_release release;
        for (std::size_t p = 0; p < polygons.size(); ++p) {
          if (auto found = complaint(polygons[p])) return std::tuple{p, *std::move(found)};
        }
        return std::nullopt;
      },
      "coords"_a, "ring_starts"_a, "polygon_starts"_a);
}

}  // namespace

NB_MODULE(_core, m) {  // NOLINT(bugprone-signed-bitwise): inside the macro
  m.attr("MIN_COORDINATE") = pdg::kMinCoordinate;
  m.attr("MAX_COORDINATE") = pdg::kMaxCoordinate;
  bind_piece_set(m);
  bind_depths(m);
  bind_motions(m);
  bind_validity(m);
}
