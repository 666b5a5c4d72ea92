#include "cells.hpp"

#include <nanobind/ndarray.h>

#include <cstddef>
#include <cstring>
#include <initializer_list>
#include <memory>
#include <vector>

namespace nb = nanobind;

namespace bindings {

namespace {

// A column of rows, copied into an array of `Value` with these trailing dimensions.
template <class Value, class Row>
nb::object array_of(const std::vector<Row>& rows, const std::initializer_list<std::size_t> shape) {
  const std::size_t count = rows.size() * sizeof(Row) / sizeof(Value);
  auto data = std::make_unique<Value[]>(count);
  if (count > 0) std::memcpy(data.get(), rows.data(), count * sizeof(Value));
  Value* const raw = data.get();
  const nb::capsule owner(data.release(), [](void* p) noexcept {
    const std::unique_ptr<Value[]> reclaim(static_cast<Value*>(p));
  });
  return nb::ndarray<nb::numpy, Value>(raw, shape, owner).cast();
}

}  // namespace

nb::dict table_dict(const planner::CellTable& table, const planner::Vec2 point) {
  const std::size_t count = table.label.size();
  nb::dict out;
  out["lower"] = array_of<double>(table.lower, {count, 3});
  out["upper"] = array_of<double>(table.upper, {count, 3});
  out["level"] = array_of<std::uint8_t>(table.level, {count, 3});
  out["label"] = array_of<std::uint8_t>(table.label, {count});
  out["point"] = nb::make_tuple(point.x, point.y);
  return out;
}

nb::dict cells(const planner::Planner& planner) {
  return table_dict(planner.cells(), planner.planned_point());
}

nb::dict thinnest_wall(planner::Planner& planner) {
  planner::Crossing found;
  {
    const nb::gil_scoped_release release;
    found = planner.thinnest_wall();
  }
  std::vector<std::array<double, 3>> way;
  way.reserve(found.way.size());
  for (const planner::Configuration& q : found.way) way.push_back({q.x, q.y, q.theta});
  nb::dict out;
  out["way"] = array_of<double>(way, {way.size(), 3});
  out["depth"] = array_of<double>(found.depth, {found.depth.size()});
  out["deepest"] = found.deepest;
  return out;
}

}  // namespace bindings
