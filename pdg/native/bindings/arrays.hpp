// Every file of bindings shares these array types and conversions of plain tuples to and from the
// core's structs.
#pragma once

#include <nanobind/nanobind.h>
#include <nanobind/ndarray.h>

#include <cstdint>
#include <initializer_list>
#include <memory>
#include <tuple>
#include <utility>
#include <vector>

#include "pdg/native/depth/translational_depth.hpp"
#include "pdg/native/geometry/motion.hpp"
#include "pdg/native/geometry/motion_bound.hpp"
#include "pdg/native/geometry/polygon.hpp"
#include "pdg/native/pieces/piece_set.hpp"

namespace pdg::python {

namespace nb = nanobind;

using Coords = nb::ndarray<const double, nb::shape<-1, 2>, nb::c_contig, nb::device::cpu>;
using Starts = nb::ndarray<const std::uint32_t, nb::shape<-1>, nb::c_contig, nb::device::cpu>;
using CoordsOut = nb::ndarray<nb::numpy, double, nb::shape<-1, 2>>;
using StartsOut = nb::ndarray<nb::numpy, std::uint32_t, nb::shape<-1>>;
using Pair = std::pair<double, double>;
using Triple = std::tuple<double, double, double>;
using DepthTuple = std::tuple<int, double, Pair, Pair, Pair>;

inline pdg::Pose to_pose(const Triple& q) {
  return {{std::get<0>(q), std::get<1>(q)}, std::get<2>(q)};
}

inline pdg::HalfExtents to_half_extents(const Triple& h) {
  return {std::get<0>(h), std::get<1>(h), std::get<2>(h)};
}

inline Pair to_pair(const pdg::Vec2 v) {
  return {v.x, v.y};
}

inline DepthTuple to_tuple(const pdg::TranslationalDepth& d) {
  return {static_cast<int>(d.state), d.depth, to_pair(d.direction), to_pair(d.on_a),
          to_pair(d.on_b)};
}

// Ring r is coords[ring_starts[r] : ring_starts[r + 1]], polygon p has the rings
// polygon_starts[p] : polygon_starts[p + 1], the outer one first.
inline std::vector<pdg::Polygon> to_polygons(const Coords& coords, const Starts& ring_starts,
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

}  // namespace pdg::python
