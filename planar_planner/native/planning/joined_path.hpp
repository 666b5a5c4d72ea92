// A path of parts one after the other, of which some are exact.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "planar_planner/native/layers/lattice.hpp"
#include "planar_planner/native/search/query.hpp"
#include "planar_planner/native/world/problem.hpp"

namespace planner {

struct JoinedPath {
  std::vector<Configuration> waypoints;
  std::vector<ExactRun> exact;

  // Both go on where the path ends: with the same doubles, or a leg with an angle that is the same
  // but for whole turns.
  void append(std::vector<Configuration> part, std::span<const ExactRun> runs = {});
  void append(ExactLeg leg);
};

// The way's points in the user's unit, all at one angle; empty if a coordinate is no double.
std::optional<std::vector<Configuration>> on_way(const Lattice& lattice,
                                                 std::span<const LatticePoint> way, double theta);

}  // namespace planner
