#include "label.hpp"

#include <algorithm>
#include <cmath>

#include "pdg/native/geometry/motion_bound.hpp"
#include "planar_planner/native/configurations/nearby.hpp"
#include "tuning.hpp"

namespace planner {

using pdg::Motion;

namespace {

void add_sway(LabelResult& result, const pdg::Sway& more) {
  result.sway.g1 += more.g1;
  result.sway.g2 += more.g2;
  result.sway.turn += more.turn;
}

// A pair or node that is still closed counts as swayed by as much as the motion moves the robot.
pdg::Sway whole_sway(const Motion& m, const double radius) {
  return {m.g1_length, m.g2_length, radius * m.half_angle};
}

// Puts one pair first: the children meet the likeliest witness of FULL at once.
void bring_forward(ConstraintList& list, const std::size_t pair, const std::size_t constraint) {
  const auto begin = list.constraints.begin();
  const auto from = begin + static_cast<std::ptrdiff_t>(constraint);
  std::rotate(begin, from, from + list.pairs[pair].count);
  const auto header = list.pairs.begin() + static_cast<std::ptrdiff_t>(pair);
  std::rotate(list.pairs.begin(), header, header + 1);
}

}  // namespace

// State of one labelling; false from a visitor means FULL: stop.
struct Labeller::Pass {
  const Motion& motion;
  PosedRobot& posed;
  Vec2 extent;  // half-extents of the translations along x and y
  double extent_norm;
  LabelResult result;
  double least = INFINITY;     // separation of the deepest open pair left undecided
  std::size_t deepest = 0;     // its place among the pairs
  std::size_t deepest_at = 0;  // and of its first constraint
};

Labeller::Labeller(const Robot& robot, ObstacleTree& tree, Statistics& statistics,
                   const Ablation& ablation)
    : robot_(robot), tree_(tree), statistics_(statistics), ablation_(ablation) {
  if (!ablation_.hierarchy) tree_.expand_all();
}

void Labeller::root_list(ConstraintList& out) const {
  out.clear();
  for (std::uint32_t wall = 0; wall < tree_.wall_count(); ++wall) {
    const std::size_t before = out.constraints.size();
    pdg::all_constraints(robot_.pieces.back(), tree_.piece(wall), out.constraints);
    out.pairs.push_back(
        {wall, robot_.hull(), static_cast<std::uint16_t>(out.constraints.size() - before)});
  }
  if (ablation_.hierarchy) {
    if (!tree_.empty()) out.pairs.push_back({tree_.root(), kNode, 0});
    return;
  }
  for (std::uint32_t piece = tree_.wall_count(); piece < tree_.piece_count(); ++piece)
    for (std::size_t i = 0; i < robot_.body_pieces(); ++i)
      out.pairs.push_back({piece, static_cast<std::uint16_t>(i), 0});
}

LabelResult Labeller::label(const Motion& motion, PosedRobot& posed, const ConstraintView& parent,
                            ConstraintList room) {
  room.clear();
  const Vec2 extent = box_extent(motion);
  Pass pass{motion, posed, extent, pdg::norm(extent), {}};
  pass.result.undecided = std::move(room);
  pass.result.clearance = INFINITY;
  pass.result.separation = INFINITY;
  std::size_t at = 0;
  for (const PairHeader& header : parent.pairs) {
    bool go_on = true;
    if (header.robot == kNode)
      go_on = visit_node(pass, header.obstacle);
    else if (closed(header))
      go_on = visit_closed_pair(pass, header.obstacle, header.robot);
    else
      go_on =
          judge(pass, header.obstacle, header.robot, parent.constraints.subspan(at, header.count));
    at += header.count;
    if (!go_on) return std::move(pass.result);
  }
  ConstraintList& undecided = pass.result.undecided;
  pass.result.label = undecided.pairs.empty() ? Label::kFree : Label::kMixed;
  if (pass.deepest != 0) bring_forward(undecided, pass.deepest, pass.deepest_at);
  return std::move(pass.result);
}

bool Labeller::visit_node(Pass& pass, const std::uint32_t index) {
  const TreeNode& node = tree_.node(index);
  const double gap = node_gap(pass.motion, robot_.reach, node);
  if (gap >= pass.motion.margin) {
    pass.result.clearance = std::min(pass.result.clearance, gap);
    return true;
  }
  // A pair can only fill a box that is no larger than its Minkowski sum; and no guard sees round
  // something small inside a large cell. Until then the node stays closed.
  if (std::max(pass.extent.x, pass.extent.y) > robot_.reach + node.largest_leaf) {
    pass.result.undecided.pairs.push_back({index, kNode, 0});
    pass.result.turning_radius = robot_.reach;
    add_sway(pass.result, whole_sway(pass.motion, robot_.reach));
    pass.result.separation = std::min(pass.result.separation, 0.0);
    return true;
  }
  if (apart_from_hull(pass, index)) return true;
  tree_.expand(index);
  if (tree_.node(index).piece != kNoPiece) return visit_piece(pass, tree_.node(index).piece);
  const std::uint32_t left = tree_.node(index).left;
  return visit_node(pass, left) && visit_node(pass, left + 1);
}

// A polygon from whose hull every robot piece keeps away need not be decomposed yet.
bool Labeller::apart_from_hull(Pass& pass, const std::uint32_t node) {
  const pdg::ConvexPiece* const hull = tree_.hull(node);
  if (hull == nullptr) return false;
  double clearance = INFINITY;
  for (std::size_t i = 0; i < robot_.body_pieces(); ++i) {
    const pdg::ConvexPiece& a = robot_.pieces[i];
    double gap = circle_gap(pass.motion, pass.posed.rotation(), a, *hull);
    if (gap < pass.motion.margin) {
      fresh_.clear();
      undecided_.clear();
      pdg::all_constraints(a, *hull, fresh_);
      const pdg::PairVerdict verdict =
          pdg::judge_pair(pass.posed.piece(i), *hull, pass.motion, fresh_, undecided_,
                          statistics_.separation_evaluations);
      if (verdict.label != pdg::PairLabel::kApart) return false;
      gap = verdict.clearance;
    }
    clearance = std::min(clearance, gap);
  }
  pass.result.clearance = std::min(pass.result.clearance, clearance);
  return true;
}

bool Labeller::visit_piece(Pass& pass, const std::uint32_t piece) {
  if (touched_.size() <= piece) touched_.resize(tree_.piece_count());
  if (!touched_[piece]) {
    touched_[piece] = true;
    pairs_touched_ += robot_.body_pieces();
  }
  for (std::size_t i = 0; i < robot_.body_pieces(); ++i)
    if (!visit_closed_pair(pass, piece, static_cast<std::uint16_t>(i))) return false;
  return true;
}

double Labeller::opening(const Vec2 extent, const Vec2 between, const double radii) const {
  if (robot_.body_pieces() < kManyPieces) return kOpeningOfFew;
  const Vec2 corner{std::abs(between.x) + extent.x, std::abs(between.y) + extent.y};
  return pdg::norm(corner) < radii ? kCoveringOfMany : kOpeningOfMany;
}

bool Labeller::visit_closed_pair(Pass& pass, const std::uint32_t obstacle,
                                 const std::uint16_t robot) {
  const pdg::ConvexPiece& a = robot_.pieces[robot];
  const pdg::ConvexPiece& b = tree_.piece(obstacle);
  const Vec2 between = between_circles(pass.motion, pass.posed.rotation(), a, b);
  const double gap = circle_gap(pass.motion, between, a, b);
  LabelResult& result = pass.result;
  if (gap >= pass.motion.margin) {
    result.clearance = std::min(result.clearance, gap);
    return true;
  }
  const double radii = a.radius + b.radius;
  const double motion_radius = pass.extent_norm + a.reach * pass.motion.half_angle;
  if (motion_radius > opening(pass.extent, between, radii) * radii) {
    pass.result.undecided.pairs.push_back({obstacle, robot, 0});
    const double inner = a.inner_radius + b.inner_radius;
    result.separation = std::min(result.separation, pdg::norm(between) - 0.5 * (radii + inner));
    result.turning_radius = std::max(result.turning_radius, a.reach);
    add_sway(result, whole_sway(pass.motion, a.reach));
    return true;
  }
  fresh_.clear();
  pdg::all_constraints(a, b, fresh_);
  return judge(pass, obstacle, robot, fresh_);
}

bool Labeller::judge(Pass& pass, const std::uint32_t obstacle, const std::uint16_t robot,
                     const std::span<const pdg::Constraint> active) {
  const std::size_t before = pass.result.undecided.constraints.size();
  pdg::PairVerdict verdict =
      pdg::judge_pair(pass.posed.piece(robot), tree_.piece(obstacle), pass.motion, active,
                      pass.result.undecided.constraints, statistics_.separation_evaluations);
  LabelResult& result = pass.result;
  switch (verdict.label) {
    case pdg::PairLabel::kApart:
      result.clearance = std::min(result.clearance, verdict.clearance);
      return true;
    case pdg::PairLabel::kOverlap:
      if (ablation_.query != CullingQuery::kPerNormal && !culls(pass, obstacle, robot)) {
        pass.result.undecided.constraints.insert(pass.result.undecided.constraints.end(),
                                                 active.begin(), active.end());
        verdict.sway = whole_sway(pass.motion, robot_.pieces[robot].reach);
        verdict.centre = std::max(verdict.centre, -robot_.reach);  // a hint, but a finite one
        break;
      }
      result.label = Label::kFull;
      result.witness = {obstacle, robot};
      result.separation = verdict.centre;
      return false;
    case pdg::PairLabel::kUndecided:
      break;
  }
  pass.result.undecided.pairs.push_back(
      {obstacle, robot,
       static_cast<std::uint16_t>(pass.result.undecided.constraints.size() - before)});
  if (verdict.centre < pass.least) {
    pass.least = verdict.centre;
    pass.deepest = pass.result.undecided.pairs.size() - 1;
    pass.deepest_at = before;
  }
  result.separation = std::min(result.separation, verdict.centre);
  result.turning_radius = std::max(result.turning_radius, robot_.pieces[robot].reach);
  add_sway(result, verdict.sway);
  return true;
}

// The scalar forms of the query: the depth at the centre against how far the cell's motion goes.
bool Labeller::culls(const Pass& pass, const std::uint32_t obstacle,
                     const std::uint16_t robot) const {
  if (ablation_.query == CullingQuery::kNone) return false;
  const pdg::PosedPiece a = pass.posed.piece(robot);
  const pdg::ConvexPiece& b = tree_.piece(obstacle);
  const Motion centre = pdg::centre_of(pass.motion);
  const double error = pdg::separation_error(*a.piece, b, centre);
  std::vector<pdg::Constraint> all;
  pdg::all_constraints(*a.piece, b, all);
  double shallowest = -INFINITY;
  for (pdg::Constraint& c : all)
    shallowest = std::max(shallowest, pdg::constraint_range(a, b, centre, error, c).hi);
  const pdg::HalfExtents half{pass.extent.x, pass.extent.y, pass.motion.half_angle};
  const double bound = ablation_.query == CullingQuery::kPublished
                           ? pdg::sum_bound(half, robot_.reach)
                           : pdg::displacement_bound(half, a.piece->reach);
  return -shallowest - error > bound;
}

}  // namespace planner
