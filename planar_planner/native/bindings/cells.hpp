// The leaves of the subdivision, and where its wall is thinnest, as numpy arrays
// (planar_planner/explain/cells.py, planar_planner/explain/thinnest_place.py).
#pragma once

#include <nanobind/nanobind.h>

#include "planar_planner/native/planning/planner.hpp"

namespace bindings {

// "lower", "upper", "level" and "label" of a table of cells, and "point", the point of the robot's
// frame that they are of.
nanobind::dict table_dict(const planner::CellTable& table, planner::Vec2 point);
nanobind::dict cells(const planner::Planner& planner);
// "way", "depth" and "deepest" of planner::Crossing.
nanobind::dict thinnest_wall(planner::Planner& planner);

}  // namespace bindings
