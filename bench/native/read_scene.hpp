// Scenes as plain numbers on a stream: what bench/lib/native.py writes of a valid problem.
#pragma once

#include <iosfwd>

#include "planar_planner/native/world/problem.hpp"

namespace bench {

struct Task {
  planner::Problem scene;
  planner::Configuration start, goal;
};

// Throws std::runtime_error if the stream ends early or holds something else than numbers.
//   task:    rotation box bounds workspace robot obstacles start goal
//   box, bounds: 0, or 1 and four numbers;  workspace: 0, or 1 and polygons
//   polygons: points, then ring starts, then polygon starts, each after its count
Task read_task(std::istream& in);

}  // namespace bench
