#include "state_check.hpp"

#include <algorithm>
#include <cmath>

#include "pdg/native/tolerances.hpp"
#include "planar_planner/native/configurations/nearby.hpp"
#include "planar_planner/native/configurations/quarter_turn.hpp"
#include "planar_planner/native/configurations/scaled_configuration.hpp"

namespace planner {

namespace {

// Bounds the error of every comparison below (docs/rounding.md): separating-axis functions of a
// single configuration, distances of circles, boxes of placed vertices.
double rounding_bound(const double robot_reach, const double obstacle_reach, const double t_reach) {
  return pdg::kSeparationErrorUnits * pdg::kUnitRoundoff * (robot_reach + obstacle_reach + t_reach);
}

// All translations in the domain, at one angle.
pdg::Motion anywhere(const Domain& domain) {
  const Vec2 half = 0.5 * domain.size;
  return pdg::make_motion(domain.low + half, {half.x, 0.0}, {0.0, half.y}, {}, domain.reach);
}

Rectangle user_bounds(const ScaledProblem& problem) {
  const Domain& d = problem.domain;
  Rectangle r{to_user(problem, d.low), to_user(problem, d.low + d.size)};
  if (problem.reference_bounds) {
    const Rectangle& b = *problem.reference_bounds;
    r = {{std::max(r.low.x, b.low.x), std::max(r.low.y, b.low.y)},
         {std::min(r.high.x, b.high.x), std::min(r.high.y, b.high.y)}};
  }
  return r;
}

}  // namespace

void StateCheck::Shapes::add(const pdg::ConvexPiece& piece, const double error) {
  pieces.push_back({static_cast<std::uint32_t>(vertices.size()),
                    static_cast<std::uint32_t>(piece.edges.size()), piece.centre,
                    piece.inner_centre, piece.radius, piece.inner_radius, error});
  for (const pdg::Edge& edge : piece.edges) {
    vertices.push_back(edge.vertex);
    normals.push_back(edge.normal);
    offsets.push_back(edge.offset);
  }
}

StateCheck::StateCheck(const ScaledProblem& problem)
    : frame_(problem.frame),
      scale_(std::ldexp(1.0, problem.frame.exponent)),
      scaled_origin_(scale_ * problem.frame.origin),
      domain_(problem.domain),
      reference_bounds_(problem.reference_bounds),
      bounds_(user_bounds(problem)),
      robot_radius_(length_to_user(problem, problem.robot.reach)),
      robot_reach_(problem.robot.reach) {
  const Robot& robot = problem.robot;
  for (const pdg::Edge& edge : robot.pieces[robot.hull()].edges) hull_.push_back(edge.vertex);
  for (std::size_t i = 0; i < robot.body_pieces(); ++i) robot_.add(robot.pieces[i], 0.0);
  turned_ = robot_;
  turned_at_.resize(robot_.pieces.size());
  if (!problem.walls.empty()) {
    const auto wall = [&](const std::size_t i) {
      const pdg::ConvexPiece& piece = problem.walls[i];
      return piece.edges[0].offset + rounding_bound(robot_reach_, piece.reach, domain_.reach);
    };
    walls_ = Rectangle{{wall(0), wall(2)}, {-wall(1), -wall(3)}};
  }
  ObstacleTree tree(all_obstacles(problem), problem.frame, {});
  if (!tree.empty()) flatten(tree, tree.root(), anywhere(domain_));
}

void StateCheck::flatten(ObstacleTree& tree, const std::uint32_t index, const pdg::Motion& domain) {
  if (node_gap(domain, robot_reach_, tree.node(index)) >= 0.0) return;  // out of reach
  tree.expand(index);
  const TreeNode node = tree.node(index);
  const double largest = std::max(std::max(std::abs(node.low.x), std::abs(node.high.x)),
                                  std::max(std::abs(node.low.y), std::abs(node.high.y)));
  const double error = rounding_bound(robot_reach_, largest, domain_.reach);
  const std::size_t at = nodes_.size();
  nodes_.push_back({{node.low.x - error, node.low.y - error},
                    {node.high.x + error, node.high.y + error},
                    0,
                    kNoPiece});
  if (node.piece == kNoPiece) {
    flatten(tree, node.left, domain);
    flatten(tree, node.left + 1, domain);
  } else {
    const pdg::ConvexPiece& piece = tree.piece(node.piece);
    nodes_[at].piece = static_cast<std::uint32_t>(obstacles_.pieces.size());
    obstacles_.add(piece, rounding_bound(robot_reach_, piece.reach, domain_.reach));
  }
  nodes_[at].escape = static_cast<std::uint32_t>(nodes_.size());
}

bool StateCheck::is_free(const Configuration& q) {
  ++checks_;
  if (!pose(q)) return false;
  if (last_hit_ != kNoPiece && meets(nodes_[last_hit_]) && overlaps(nodes_[last_hit_].piece))
    return false;
  const auto end = static_cast<std::uint32_t>(nodes_.size());
  for (std::uint32_t i = 0; i < end;) {
    const Node& node = nodes_[i];
    if (!meets(node)) {
      i = node.escape;
      continue;
    }
    if (node.piece != kNoPiece && i != last_hit_ && overlaps(node.piece)) {
      last_hit_ = i;
      return false;
    }
    ++i;
  }
  return true;
}

// Places the robot's hull; false if it is out of bounds. Comparisons are written so that a
// coordinate that is not a number fails them.
bool StateCheck::pose(const Configuration& q) {
  if (!std::isfinite(q.theta)) return false;
  if (reference_bounds_) {
    const Rectangle& r = *reference_bounds_;
    if (!(q.x >= r.low.x && q.x <= r.high.x && q.y >= r.low.y && q.y <= r.high.y)) return false;
  }
  t_ = scale_ * Vec2{q.x, q.y} - scaled_origin_;
  const Vec2 place = t_ - domain_.low;
  if (!(place.x >= 0.0 && place.x <= domain_.size.x && place.y >= 0.0 && place.y <= domain_.size.y))
    return false;
  rotation_ = rotation_at(q.theta);
  low_ = {INFINITY, INFINITY};
  high_ = {-INFINITY, -INFINITY};
  for (const Vec2 a : hull_) {
    const Vec2 p = pdg::rotate(rotation_, a);
    low_ = {std::min(low_.x, p.x), std::min(low_.y, p.y)};
    high_ = {std::max(high_.x, p.x), std::max(high_.y, p.y)};
  }
  low_ = low_ + t_;
  high_ = high_ + t_;
  return !walls_ || (low_.x >= walls_->low.x && low_.y >= walls_->low.y &&
                     high_.x <= walls_->high.x && high_.y <= walls_->high.y);
}

bool StateCheck::meets(const Node& node) const {
  return low_.x < node.high.x && node.low.x < high_.x && low_.y < node.high.y &&
         node.low.y < high_.y;
}

// True if some piece of the robot is not separated from the obstacle beyond doubt.
bool StateCheck::overlaps(const std::uint32_t obstacle) {
  const Piece& b = obstacles_.pieces[obstacle];
  for (std::size_t i = 0; i < robot_.pieces.size(); ++i) {
    const Piece& a = robot_.pieces[i];
    const Vec2 centre = t_ + pdg::rotate(rotation_, a.centre);
    if (pdg::norm(centre - b.centre) >= a.radius + b.radius + b.error) continue;
    if (turned_at_[i] != checks_) turn_piece(i);
    if (!separated(turned_.pieces[i], b)) return true;
  }
  return false;
}

void StateCheck::turn_piece(const std::size_t i) {
  turned_at_[i] = checks_;
  const Piece& a = robot_.pieces[i];
  turned_.pieces[i].centre = pdg::rotate(rotation_, a.centre);
  turned_.pieces[i].inner_centre = pdg::rotate(rotation_, a.inner_centre);
  for (std::uint32_t k = a.first; k < a.first + a.count; ++k) {
    turned_.vertices[k] = pdg::rotate(rotation_, robot_.vertices[k]);
    turned_.normals[k] = pdg::rotate(rotation_, robot_.normals[k]);
  }
}

namespace {

// One side of the separating-axis test: is some edge (normals, offsets) at least `error` short of
// every one of `points`? The edge that faces the other piece's centre is tried first, and an edge
// that cuts the other piece's inner circle is not tried at all. All in one frame.
bool separated_by_edge(const Vec2* const normals, const double* const offsets,
                       const std::uint32_t edges, const Vec2* const points,
                       const std::uint32_t count, const Vec2 shift, const Vec2 inner_centre,
                       const double inner_radius, const double error) {
  const auto apart = [&](const std::uint32_t k) {
    const double least = offsets[k] + error;
    const double moved = dot(normals[k], shift);
    for (std::uint32_t i = 0; i < count; ++i)
      if (!(dot(normals[k], points[i]) + moved >= least)) return false;
    return true;
  };
  std::uint32_t facing = 0;
  double best = -INFINITY;
  for (std::uint32_t k = 0; k < edges; ++k) {
    const double height = dot(normals[k], inner_centre) - offsets[k];
    if (height > best) best = height, facing = k;
  }
  if (best < inner_radius) return false;
  if (apart(facing)) return true;
  for (std::uint32_t k = 0; k < edges; ++k)
    if (k != facing && dot(normals[k], inner_centre) - offsets[k] >= inner_radius && apart(k))
      return true;
  return false;
}

}  // namespace

// `a` is turned, but its place is relative to t.
bool StateCheck::separated(const Piece& a, const Piece& b) const {
  return separated_by_edge(&obstacles_.normals[b.first], &obstacles_.offsets[b.first], b.count,
                           &turned_.vertices[a.first], a.count, t_, a.inner_centre + t_,
                           a.inner_radius, b.error) ||
         separated_by_edge(&turned_.normals[a.first], &turned_.offsets[a.first], a.count,
                           &obstacles_.vertices[b.first], b.count, -t_, b.inner_centre - t_,
                           b.inner_radius, b.error);
}

}  // namespace planner
