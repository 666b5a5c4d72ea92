#include "queries.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "pdg/native/motion_bound.hpp"
#include "planar_planner/native/nearby.hpp"

namespace bench {

namespace {

using planner::Label;

pdg::Motion centre_of(const pdg::Motion& motion) {
  pdg::Motion centre;
  centre.t = motion.t;
  centre.reach = motion.reach;
  return centre;
}

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

bool scalar(World& world, const pdg::Motion& motion, const pdg::PosedRobot& posed,
            const bool published) {
  const planner::Robot& robot = world.problem.robot;
  const pdg::HalfExtents half{motion.g1.x, motion.g2.y, motion.half_angle};
  const double whole = pdg::sum_bound(half, robot.reach);
  const pdg::Motion centre = centre_of(motion);
  for (const planner::Witness& pair : world.near) {
    const double bound =
        published ? whole : pdg::displacement_bound(half, robot.pieces[pair.robot].reach);
    const pdg::PosedPiece a = posed_piece(robot, posed, pair.robot);
    if (depth_at_centre(world, a, world.tree.piece(pair.obstacle), centre) > bound) return true;
  }
  return false;
}

bool per_normal(World& world, const pdg::Motion& motion, const pdg::PosedRobot& posed) {
  const planner::Robot& robot = world.problem.robot;
  for (const planner::Witness& pair : world.near) {
    const pdg::PosedPiece a = posed_piece(robot, posed, pair.robot);
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

// At most so many pairs are told apart by cases, with so many axes together (a product).
constexpr std::size_t kCasePairs = 3;
constexpr std::size_t kCaseProduct = 27;

// Is the cell obstructed with each of the pairs `branching` (places in world.list) restricted to
// any one of its active axes? world.list is the cell's undecided list.
bool obstructed_in_all_cases(World& world, const pdg::Motion& motion,
                             const pdg::PosedRobot& posed) {
  const planner::ConstraintList& list = world.list;
  if (world.joint.obstructs(motion, posed, view(list))) return true;
  std::vector<std::size_t> branching;
  for (std::size_t i = 0; i < list.pairs.size(); ++i)
    if (list.pairs[i].count > 1) branching.push_back(i);
  std::stable_sort(branching.begin(), branching.end(),
                   [&](const std::size_t i, const std::size_t j) {
                     return list.pairs[i].count < list.pairs[j].count;
                   });
  std::size_t product = 1;
  std::vector<std::size_t> axis(list.pairs.size(), 0);
  std::vector<std::size_t> used;
  for (const std::size_t i : branching) {
    if (used.size() == kCasePairs || product * list.pairs[i].count > kCaseProduct) break;
    product *= list.pairs[i].count;
    used.push_back(i);
  }
  if (used.empty()) return false;
  for (std::size_t number = 0; number < product; ++number) {
    std::size_t rest = number;
    for (const std::size_t i : used) {
      axis[i] = rest % list.pairs[i].count;
      rest /= list.pairs[i].count;
    }
    planner::ConstraintList& chosen = world.chosen;
    chosen.clear();
    std::size_t at = 0;
    for (std::size_t i = 0; i < list.pairs.size(); ++i) {
      const planner::PairHeader& pair = list.pairs[i];
      if (pair.count == 1 || std::find(used.begin(), used.end(), i) != used.end()) {
        chosen.pairs.push_back({pair.obstacle, pair.robot, 1});
        chosen.constraints.push_back(list.constraints[at + axis[i]]);
      }
      at += pair.count;
    }
    if (!world.joint.obstructs(motion, posed, view(chosen))) return false;
  }
  return true;
}

}  // namespace

World::World(planner::Scene scene, const planner::Parts& parts, const double fixed_theta)
    : problem(planner::make_problem(std::move(scene), parts)),
      tree(problem.scene.obstacles, problem.frame, problem.walls, parts.partition),
      labeller(problem.robot, tree, statistics, parts),
      star(problem.robot, tree),
      joint(problem.robot, tree),
      space{problem.domain, problem.rotation, fixed_theta} {}

bool proves(World& world, const Visit& visit, const Query query) {
  const pdg::Motion motion = motion_of(world.space, visit.box);
  const pdg::Rotation rotation = rotation_of(world.space, visit.box);
  const pdg::PosedRobot& posed = world.labeller.posed(rotation);
  if (query == Query::kLabel || query == Query::kJoint || query == Query::kCases) {
    const planner::LabelResult result =
        world.labeller.label(motion, posed, view(*visit.parent), world.list);
    if (result.label == Label::kFull) return true;
    if (query == Query::kLabel || result.label != Label::kMixed || result.separation >= 0.0)
      return false;
    return query == Query::kJoint ? world.joint.obstructs(motion, posed, view(world.list))
                                  : obstructed_in_all_cases(world, motion, posed);
  }
  find_near(world, motion, rotation);
  if (query == Query::kAlone) return per_normal(world, motion, posed);
  return scalar(world, motion, posed, query == Query::kPublished);
}

}  // namespace bench
