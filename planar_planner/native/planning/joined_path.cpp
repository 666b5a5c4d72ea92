#include "joined_path.hpp"

#include <cstddef>
#include <utility>

#include "planar_planner/native/configurations/quarter_turn.hpp"

namespace planner {

void JoinedPath::append(std::vector<Configuration> part, const std::span<const ExactRun> runs) {
  if (!waypoints.empty()) waypoints.pop_back();
  const std::size_t offset = waypoints.size();
  for (const ExactRun& run : runs)
    exact.push_back({run.first + offset, run.last + offset, run.layer});
  waypoints.insert(waypoints.end(), part.begin(), part.end());
}

void JoinedPath::append(ExactLeg leg) {
  const ExactRun run{0, leg.way.size() - 1, leg.layer};
  if (!waypoints.empty())
    for (Configuration& q : leg.way) q.theta = nearest_turn(q.theta, waypoints.back().theta);
  append(std::move(leg.way), {&run, 1});
}

std::optional<std::vector<Configuration>> on_way(const Lattice& lattice,
                                                 const std::span<const LatticePoint> way,
                                                 const double theta) {
  std::vector<Configuration> out;
  out.reserve(way.size());
  for (const LatticePoint p : way) {
    const std::optional<Vec2> at = to_user(lattice, p);
    if (!at) return std::nullopt;
    out.push_back({at->x, at->y, theta});
  }
  return out;
}

}  // namespace planner
