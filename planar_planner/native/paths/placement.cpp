#include "placement.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "pdg/native/depth/translational_depth.hpp"
#include "planar_planner/native/configurations/nearby.hpp"
#include "planar_planner/native/configurations/quarter_turn.hpp"
#include "planar_planner/native/tolerances.hpp"
#include "tuning.hpp"

namespace planner {

namespace {

pdg::ConvexPolygon turned(const pdg::ConvexPiece& piece, const pdg::Rotation rotation,
                          const Vec2 t) {
  pdg::ConvexPolygon out;
  out.reserve(piece.edges.size());
  for (const pdg::Edge& edge : piece.edges) out.push_back(pdg::rotate(rotation, edge.vertex) + t);
  return out;
}

pdg::ConvexPolygon polygon_of(const pdg::ConvexPiece& piece) {
  return turned(piece, pdg::Rotation{}, Vec2{});
}

struct Deepest {
  double depth = -INFINITY;  // planner units
  std::uint32_t obstacle = 0;
  std::size_t robot = 0;
};

// How far the hull reaches into a wall.
double wall_depth(const pdg::ConvexPolygon& hull, const pdg::Edge& wall) {
  double depth = -INFINITY;
  for (const Vec2 p : hull) depth = std::max(depth, wall.offset - dot(wall.normal, p));
  return depth;
}

Deepest deepest_pair(const ScaledProblem& problem, ObstacleTree& tree, const pdg::Motion& motion,
                     const pdg::Rotation rotation) {
  std::vector<pdg::ConvexPolygon> bodies;
  bodies.reserve(problem.robot.pieces.size());
  for (const pdg::ConvexPiece& piece : problem.robot.pieces)
    bodies.push_back(turned(piece, rotation, motion.t));
  Deepest deepest;
  visit_nearby_pairs(problem.robot, tree, motion, rotation, kTouchingGap,
                     [&](const std::uint32_t obstacle, const std::size_t robot) {
                       const pdg::ConvexPiece& b = tree.piece(obstacle);
                       const double depth =
                           b.vertex_count == 0
                               ? wall_depth(bodies[robot], b.edges[0])
                               : pdg::translational_depth(bodies[robot], polygon_of(b)).depth;
                       if (depth > deepest.depth) deepest = {depth, obstacle, robot};
                     });
  return deepest;
}

}  // namespace

double outside_bounds(const ScaledProblem& problem, const Configuration& q) {
  if (!problem.reference_bounds) return 0.0;
  const Rectangle& r = *problem.reference_bounds;
  return std::max({r.low.x - q.x, q.x - r.high.x, r.low.y - q.y, q.y - r.high.y, 0.0});
}

Placement place(const ScaledProblem& problem, ObstacleTree& tree, Labeller& labeller,
                const Configuration& q) {
  Placement out;
  out.depth = outside_bounds(problem, q);
  if (out.depth > 0.0) {
    out.state = PlacementState::kOutside;
    return out;
  }
  const Vec2 t = scaled(problem, q).t;
  ConstraintList root;
  labeller.root_list(root);
  const pdg::Motion motion = pdg::make_motion(
      t, {}, {}, {}, std::max(problem.domain.reach, pdg::norm(t) * pdg::kRadiusPadding));
  const pdg::Rotation rotation = rotation_at(q.theta);
  PosedRobot posed(problem.robot);
  posed.turn_to(rotation);
  const LabelResult result = labeller.label(motion, posed, view(root));
  if (result.label == Label::kFree) {
    out.clearance = length_to_user(problem, result.clearance);
    return out;
  }
  out.witness = result.witness;
  const Deepest deepest = deepest_pair(problem, tree, motion, rotation);
  out.state = result.label == Label::kFull ? PlacementState::kColliding : PlacementState::kContact;
  if (out.state == PlacementState::kColliding)
    out.depth = length_to_user(problem, std::max(deepest.depth, 0.0));
  out.robot_polygon = problem.robot.polygon_of_piece[deepest.robot];
  const std::uint32_t polygon = tree.polygon_of_piece(deepest.obstacle);
  out.wall = polygon == kWall || polygon >= problem.given.obstacles.size();
  out.obstacle = out.wall ? -1 : static_cast<std::int64_t>(polygon);
  return out;
}

std::optional<Configuration> lift_off(const ScaledProblem& problem, SegmentTest& test,
                                      const Configuration& q, const double tolerance) {
  const double most = tolerance * (1.0 - kLiftOffUnits * pdg::kUnitRoundoff);
  const auto moved = [&](const int direction, const int k) -> std::optional<Configuration> {
    const double angle = 2.0 * std::numbers::pi * direction / kDirections;
    // Rounding of the sums may carry it beyond the tolerance, most of all far from the user's
    // origin: then a little shorter, by units of the coordinates.
    const double unit = 2.0 * pdg::kUnitRoundoff * std::max(std::abs(q.x), std::abs(q.y));
    for (int shorter = 0; shorter < 3; ++shorter) {
      const double length = std::ldexp(most, -2 * k) - shorter * unit;
      const Configuration to{q.x + length * std::cos(angle), q.y + length * std::sin(angle),
                             q.theta};
      const bool within = length > 0.0 && std::hypot(to.x - q.x, to.y - q.y) <= most;
      if (within && outside_bounds(problem, to) == 0.0) return to;
    }
    return std::nullopt;
  };
  // The shortest way off, so that none hops over a thin wall; of several the one into the open.
  for (int k = kLengths - 1; k >= 0; --k) {
    std::optional<Configuration> best;
    int best_direction = 0;
    double best_clearance = -INFINITY;
    for (int i = 0; i < kDirections; ++i) {
      const auto to = moved(i, k);
      if (!to) continue;
      const auto clearance = test.clearance(scaled(problem, *to));
      if (!clearance || *clearance <= best_clearance) continue;
      best = to;
      best_direction = i;
      best_clearance = *clearance;
    }
    if (!best) continue;
    // Further along it as far as the way stays free: room for the search to work with.
    while (--k >= 0) {
      const auto to = moved(best_direction, k);
      if (!to || !test.certify(scaled(problem, *best), scaled(problem, *to))) break;
      best = to;
    }
    return best;
  }
  return std::nullopt;
}

}  // namespace planner
