#include "truth.hpp"

#include <algorithm>
#include <memory>
#include <queue>
#include <utility>

namespace bench {

namespace {

using planner::Axis;
using planner::ConstraintList;
using planner::Extent;
using planner::kNoAxis;
using planner::kTheta;
using planner::Label;

struct Open {
  double separation;  // the hint: higher looks freer
  Extent box;
  std::shared_ptr<const ConstraintList> list;
};
bool operator<(const Open& a, const Open& b) {
  return a.separation < b.separation;
}

Extent centre_of(const Extent& box) {
  Extent point;
  for (Axis k = 0; k < kNoAxis; ++k) point.low[k] = box.low[k] + box.size[k] / 2;
  return point;
}

bool free_at_centre(World& world, const Extent& box, const ConstraintList& list) {
  const Extent point = centre_of(box);
  planner::PosedRobot& posed = world.posed_at(rotation_of(world.space, point));
  return world.labeller.label(motion_of(world.space, point), posed, view(list)).label ==
         Label::kFree;
}

}  // namespace

std::array<Extent, 2> halves_of(const World& world, const Extent& box) {
  const pdg::Motion m = motion_of(world.space, box);
  const std::array<double, 3> width{m.g1.x, m.g2.y, world.problem.robot.reach * m.half_angle};
  Axis widest = 0;
  for (Axis k = 1; k < kNoAxis; ++k)
    if (width[k] > width[widest]) widest = k;
  std::array<Extent, 2> halves{box, box};
  halves[0].size[widest] = halves[1].size[widest] = box.size[widest] / 2;
  halves[1].low[widest] += box.size[widest] / 2;
  return halves;
}

Truth refine(World& world, const Extent& box, const ConstraintList& list, const std::size_t budget,
             const bool joint) {
  if (free_at_centre(world, box, list)) return Truth::kNotAll;
  std::priority_queue<Open> open;
  open.push({0.0, box, std::make_shared<ConstraintList>(list)});
  for (std::size_t used = 0; !open.empty(); used += 2) {
    if (used >= budget) return Truth::kUndecided;
    const Open parent = open.top();
    open.pop();
    for (const Extent& half : halves_of(world, parent.box)) {
      const pdg::Motion motion = motion_of(world.space, half);
      planner::PosedRobot& posed = world.posed_at(rotation_of(world.space, half));
      const auto child = std::make_shared<ConstraintList>();
      planner::LabelResult result = world.labeller.label(motion, posed, view(*parent.list));
      *child = std::move(result.undecided);
      if (result.label == Label::kFree) return Truth::kNotAll;
      if (result.label == Label::kFull) continue;
      if (joint && result.separation < 0.0 && obstructed(world, motion, posed, *child)) continue;
      if (free_at_centre(world, half, *child)) return Truth::kNotAll;
      open.push({result.separation, half, child});
    }
  }
  return Truth::kObstacle;
}

}  // namespace bench
