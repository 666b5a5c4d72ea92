#include "misses.hpp"

#include "planar_planner/native/configurations/nearby.hpp"

namespace bench {

namespace {

constexpr std::size_t kBudget = 600;  // labels for one pair of one cell

// Everything that the cell meets, opened.
void open_all(World& world, const Seen& seen, planner::ConstraintList& out) {
  // A single configuration opens what is near it; pairs away from the centre cannot cover the cell.
  planner::Extent point;
  for (planner::Axis k = 0; k < planner::kNoAxis; ++k)
    point.low[k] = seen.visit.box.low[k] + seen.visit.box.size[k] / 2;
  out.clear();
  const pdg::Motion motion = motion_of(world.space, point);
  const pdg::Rotation rotation = rotation_of(world.space, point);
  planner::visit_nearby_pairs(
      world.problem.robot, world.tree, motion, rotation, 0.0,
      [&](const std::uint32_t obstacle, const std::size_t robot) {
        const std::size_t before = out.constraints.size();
        pdg::all_constraints(world.problem.robot.pieces[robot], world.tree.piece(obstacle),
                             out.constraints);
        out.pairs.push_back({obstacle, static_cast<std::uint16_t>(robot),
                             static_cast<std::uint16_t>(out.constraints.size() - before)});
      });
}

bool was_open(World& world, const Seen& seen, const planner::PairHeader& pair) {
  planner::PosedRobot& posed = world.posed_at(rotation_of(world.space, seen.visit.box));
  world.list =
      world.labeller.label(motion_of(world.space, seen.visit.box), posed, view(*seen.visit.parent))
          .undecided;
  for (const planner::PairHeader& header : world.list.pairs)
    if (header.obstacle == pair.obstacle && header.robot == pair.robot) return !closed(header);
  return false;
}

}  // namespace

void classify(World& world, const Seen& seen, Misses& misses) {
  planner::ConstraintList all;
  open_all(world, seen, all);
  bool unclear = false;
  std::size_t at = 0;
  for (const planner::PairHeader& pair : all.pairs) {
    planner::ConstraintList one;
    one.pairs.push_back(pair);
    one.constraints.assign(all.constraints.begin() + static_cast<std::ptrdiff_t>(at),
                           all.constraints.begin() + static_cast<std::ptrdiff_t>(at + pair.count));
    at += pair.count;
    const Truth truth = refine(world, seen.visit.box, one, kBudget, false);
    unclear = unclear || truth == Truth::kUndecided;
    if (truth != Truth::kObstacle) continue;
    ++(was_open(world, seen, pair) ? misses.slack : misses.closed);
    return;
  }
  ++(unclear ? misses.unclear : misses.several);
}

}  // namespace bench
