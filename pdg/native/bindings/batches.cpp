// Functions of many poses or cells in one call, without the interpreter's lock.
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
#include "pdg/native/depth/displacement.hpp"
#include "pdg/native/depth/generalized_depth.hpp"
#include "pdg/native/depth/nonconvex_depth.hpp"
#include "pdg/native/separation/c_obstacle_query.hpp"
#include "rows.hpp"
#include "subjects.hpp"

namespace nb = nanobind;
using namespace nb::literals;

namespace pdg::python {
namespace {

using Cells = nb::ndarray<const double, nb::shape<-1, 6>, nb::c_contig, nb::device::cpu>;
using States = nb::ndarray<nb::numpy, std::uint8_t, nb::shape<-1>>;
using Lengths = nb::ndarray<nb::numpy, double, nb::shape<-1>>;
using BoundRows = nb::ndarray<nb::numpy, double, nb::shape<-1, 4>>;
using DepthRows = nb::ndarray<nb::numpy, double, nb::shape<-1, 7>>;
using IndexPairs = nb::ndarray<nb::numpy, std::int32_t, nb::shape<-1, 2>>;

// The state of each row, and its (depth, direction, on_a, on_b).
struct DepthColumns {
  std::vector<std::uint8_t> states;
  std::vector<double> rows;

  explicit DepthColumns(const std::size_t count) : states(count), rows(7 * count) {}

  void set(const std::size_t row, const pdg::TranslationalDepth& d) {
    states[row] = static_cast<std::uint8_t>(d.state);
    const std::array<double, 7> values{d.depth,  d.direction.x, d.direction.y, d.on_a.x,
                                       d.on_a.y, d.on_b.x,      d.on_b.y};
    std::copy(values.begin(), values.end(), rows.begin() + static_cast<std::ptrdiff_t>(7 * row));
  }
  States take_states() {
    const std::size_t count = states.size();
    return to_array<std::uint8_t, States>(std::move(states), {count});
  }
  DepthRows take_rows() {
    const std::size_t count = rows.size() / 7;
    return to_array<double, DepthRows>(std::move(rows), {count, 7});
  }
};

IndexPairs to_pairs(std::vector<std::int32_t>&& pairs) {
  const std::size_t count = pairs.size() / 2;
  return to_array<std::int32_t, IndexPairs>(std::move(pairs), {count, 2});
}

auto translational_depths(const pdg::PieceSet& a, const pdg::PieceSet& b, const Poses& poses) {
  DepthColumns columns(poses.shape(0));
  const bool convex = a.polygons.size() == 1 && b.polygons.size() == 1;
  const pdg::PlacedOutline fixed = convex ? pdg::make_outline(b.polygons[0]) : pdg::PlacedOutline{};
  pdg::PlacedOutline moved;
  const std::int64_t bad = for_each_row(poses.shape(0), [&](const std::size_t row) {
    const pdg::Pose pose = pose_of(poses, row);
    columns.set(row, convex ? pdg::translational_depth(a.polygons[0], pose, fixed, moved)
                            : pdg::translational_depth(a, b, pose));
  });
  return std::tuple{bad, columns.take_states(), columns.take_rows()};
}

auto generalized_depth_lower_bounds(const pdg::PieceSet& a, const pdg::PieceSet& b,
                                    const Poses& poses) {
  DepthColumns columns(poses.shape(0));
  std::vector<std::int32_t> pairs(2 * poses.shape(0));
  pdg::DepthScratch scratch;
  const std::int64_t bad = for_each_row(poses.shape(0), [&](const std::size_t row) {
    const pdg::DepthLowerBound bound =
        pdg::generalized_depth_lower_bound(a, b, pose_of(poses, row), scratch);
    columns.set(row, bound.pair);
    pairs[2 * row] = bound.piece_a;
    pairs[2 * row + 1] = bound.piece_b;
  });
  return std::tuple{bad, to_pairs(std::move(pairs)), columns.take_states(), columns.take_rows()};
}

auto c_obstacle_queries(const pdg::PieceSet& a, const pdg::PieceSet& b, const Cells& cells,
                        const int method) {
  const std::size_t count = cells.shape(0);
  std::vector<std::uint8_t> full(count);
  std::vector<std::int32_t> pairs(2 * count);
  std::vector<double> margins(count);
  for_each_row(count, [&](const std::size_t row) {
    const double* c = cells.data() + 6 * row;
    const pdg::CObstacleVerdict verdict = pdg::c_obstacle_query(
        a, b, {{{c[0], c[1]}, c[2]}, {c[3], c[4], c[5]}}, static_cast<pdg::QueryMethod>(method));
    full[row] = verdict.full ? 1 : 0;
    pairs[2 * row] = verdict.piece_a;
    pairs[2 * row + 1] = verdict.piece_b;
    margins[row] = verdict.margin;
  });
  return std::tuple{to_array<std::uint8_t, States>(std::move(full), {count}),
                    to_pairs(std::move(pairs)),
                    to_array<double, Lengths>(std::move(margins), {count})};
}

auto displacements(const pdg::PieceSet& body, const Poses& from, const Poses& to) {
  if (from.shape(0) != to.shape(0)) throw nb::value_error("q0 and q1 differ in length");
  const std::size_t count = from.shape(0);
  std::vector<double> lengths(count);
  for_each_row(count, [&](const std::size_t row) {
    lengths[row] = pdg::displacement(body, pose_of(from, row), pose_of(to, row));
  });
  return to_array<double, Lengths>(std::move(lengths), {count});
}

// Returns (lower, upper, centre) of each row.
auto generalized_distance_bounds(const pdg::PieceSet& body, const Poses& from, const Poses& to) {
  if (from.shape(0) != to.shape(0)) throw nb::value_error("q0 and q1 differ in length");
  const std::size_t count = from.shape(0);
  std::vector<double> rows(4 * count);
  for_each_row(count, [&](const std::size_t row) {
    const pdg::DistanceBounds bounds =
        pdg::generalized_distance_bounds(body, pose_of(from, row), pose_of(to, row));
    const std::array<double, 4> values{bounds.lower, bounds.upper, bounds.centre.x,
                                       bounds.centre.y};
    std::copy(values.begin(), values.end(), rows.begin() + static_cast<std::ptrdiff_t>(4 * row));
  });
  return to_array<double, BoundRows>(std::move(rows), {count, 4});
}

}  // namespace

void bind_batches(nb::module_& m) {
  m.def("translational_depths", &translational_depths, "a"_a, "b"_a, "poses"_a);
  m.def("generalized_depth_lower_bounds", &generalized_depth_lower_bounds, "a"_a, "b"_a, "poses"_a);
  m.def("c_obstacle_queries", &c_obstacle_queries, "a"_a, "b"_a, "cells"_a, "method"_a);
  m.def("generalized_distance_bounds", &generalized_distance_bounds, "body"_a, "q0"_a, "q1"_a);
  m.def("displacements", &displacements, "body"_a, "q0"_a, "q1"_a);
}

}  // namespace pdg::python
