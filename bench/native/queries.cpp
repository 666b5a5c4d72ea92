#include "queries.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "pdg/native/geometry/motion_bound.hpp"
#include "planar_planner/native/configurations/nearby.hpp"

namespace bench {

namespace {

using planner::Label;

void find_near(World& world, const pdg::Motion& motion, const pdg::Rotation rotation) {
  world.near.clear();
  planner::visit_nearby_pairs(world.problem.robot, world.tree, centre_of(motion), rotation, 0.0,
                              [&](const std::uint32_t obstacle, const std::size_t robot) {
                                world.near.push_back({obstacle, static_cast<std::uint16_t>(robot)});
                              });
}

// PD^t of the pair at the motion's centre, rounded down; negative: apart.
double depth_at_centre(World& world, const pdg::PosedPiece& a, const pdg::ConvexPiece& b,
                       const pdg::Motion& centre) {
  const double error = pdg::separation_error(*a.piece, b, centre);
  world.all.clear();
  pdg::all_constraints(*a.piece, b, world.all);
  double shallowest = -INFINITY;
  for (pdg::Constraint& c : world.all)
    shallowest = std::max(shallowest, pdg::constraint_range(a, b, centre, error, c).hi);
  return -shallowest - error;
}

bool scalar(World& world, const pdg::Motion& motion, planner::PosedRobot& posed,
            const bool published) {
  const planner::Robot& robot = world.problem.robot;
  const pdg::HalfExtents half{motion.g1.x, motion.g2.y, motion.half_angle};
  const double whole = pdg::sum_bound(half, robot.reach);
  const pdg::Motion centre = centre_of(motion);
  for (const planner::Witness& pair : world.near) {
    const double bound =
        published ? whole : pdg::displacement_bound(half, robot.pieces[pair.robot].reach);
    const pdg::PosedPiece a = posed.piece(pair.robot);
    if (depth_at_centre(world, a, world.tree.piece(pair.obstacle), centre) > bound) return true;
  }
  return false;
}

bool per_normal(World& world, const pdg::Motion& motion, planner::PosedRobot& posed) {
  for (const planner::Witness& pair : world.near) {
    const pdg::PosedPiece a = posed.piece(pair.robot);
    const pdg::ConvexPiece& b = world.tree.piece(pair.obstacle);
    world.all.clear();
    world.left.clear();
    pdg::all_constraints(*a.piece, b, world.all);
    const pdg::PairVerdict verdict = pdg::judge_pair(a, b, motion, world.all, world.left,
                                                     world.statistics.separation_evaluations);
    if (verdict.label == pdg::PairLabel::kOverlap) return true;
  }
  return false;
}

// Joint obstruction by the pairs of world.list that have a single axis left.
bool obstructed_by_single(World& world, const pdg::Motion& motion, planner::PosedRobot& posed) {
  world.chosen.clear();
  std::size_t at = 0;
  for (const planner::PairHeader& pair : world.list.pairs) {
    if (pair.count == 1) {
      world.chosen.pairs.push_back(pair);
      world.chosen.constraints.push_back(world.list.constraints[at]);
    }
    at += pair.count;
  }
  return obstructed(world, motion, posed, world.chosen);
}

}  // namespace

World::World(planner::Problem scene, const planner::Ablation& ablation, const double fixed_theta)
    : problem(planner::make_scaled_problem(std::move(scene), ablation)),
      tree(all_obstacles(problem), problem.frame, problem.walls, ablation.partition),
      labeller(problem.robot, tree, statistics, ablation),
      posed(problem.robot),
      space{problem.domain, problem.rotation, fixed_theta} {}

bool obstructed(World& world, const pdg::Motion& motion, planner::PosedRobot& posed,
                const planner::ConstraintList& list) {
  planner::gather_terms(world.tree, motion, posed, view(list), world.scratch.terms);
  return planner::refute(world.scratch.terms, motion, world.scratch.joint).has_value();
}

bool proves(World& world, const Visit& visit, const Query query) {
  const pdg::Motion motion = motion_of(world.space, visit.box);
  const pdg::Rotation rotation = rotation_of(world.space, visit.box);
  planner::PosedRobot& posed = world.posed_at(rotation);
  if (query == Query::kLabel || query == Query::kSingle || query == Query::kJoint) {
    planner::LabelResult result = world.labeller.label(motion, posed, view(*visit.parent));
    world.list = std::move(result.undecided);
    if (result.label == Label::kFull) return true;
    if (query == Query::kLabel || result.label != Label::kMixed || result.separation >= 0.0)
      return false;
    return query == Query::kJoint ? obstructed(world, motion, posed, world.list)
                                  : obstructed_by_single(world, motion, posed);
  }
  find_near(world, motion, rotation);
  if (query == Query::kAlone) return per_normal(world, motion, posed);
  return scalar(world, motion, posed, query == Query::kPublished);
}

}  // namespace bench
