#include "wall.hpp"

#include <array>

#include "cells.hpp"
#include "planar_planner/native/evidence/wall_table.hpp"

namespace nb = nanobind;

namespace bindings {

namespace {

std::optional<planner::CellTable> wall_table(planner::Planner& planner) {
  const planner::Evidence found = planner.evidence();
  if (found.kind == planner::ClaimKind::kSeparation)
    return planner::tabulate(planner.planned_by().problem(), found.barrier);
  if (found.kind == planner::ClaimKind::kDisc)
    return planner::tabulate(planner.planned_by().disc_inside().problem(), found.barrier);
  return std::nullopt;
}

}  // namespace

std::optional<nb::dict> wall(planner::Planner& planner, const double theta) {
  std::optional<planner::CellTable> table;
  {
    const nb::gil_scoped_release release;
    table = wall_table(planner);
  }
  if (!table) return std::nullopt;
  if (!planner.problem().rotation)
    for (auto* const corners : {&table->lower, &table->upper})
      for (std::array<double, 3>& corner : *corners) corner[2] = theta;
  return table_dict(*table, planner.planned_point());
}

}  // namespace bindings
