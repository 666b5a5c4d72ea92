#include "collision.hpp"

#include <algorithm>
#include <cmath>

#include "segment.hpp"

namespace planner {

CollisionHint::CollisionHint(const ScaledProblem& problem, ObstacleTree& tree,
                             const std::size_t small)
    : problem_(problem),
      tree_(tree),
      small_(all_obstacles(problem).points() <= small),
      vertices_(problem.robot.vertex_total),
      normals_(problem.robot.vertex_total),
      turned_at_(problem.robot.pieces.size()),
      edges_(small_ ? 0 : all_obstacles(problem).size()) {}

double CollisionHint::gap(const ScaledConfiguration& q) {
  ++calls_;
  t_ = q.t;
  rotation_ = rotation_at(q.theta);
  double least = std::min(gap_to_domain(), gap_to_last_piece());
  if (least < 0.0) return kCollides;
  place_hull();
  least = std::min(least, gap_to_walls());
  if (least < 0.0) return kCollides;
  if (tree_.empty()) return least;
  open_.assign(1, tree_.root());
  while (!open_.empty()) {
    const std::uint32_t index = open_.back();
    open_.pop_back();
    ++work_;
    const double to_box = gap_to_box(tree_.node(index));
    if (to_box > 0.0) {
      least = std::min(least, to_box);
      continue;
    }
    if (small_ || !tree_.whole_polygon(index)) tree_.expand(index);
    if (const std::uint32_t left = tree_.node(index).left; left != 0) {
      open_.push_back(left + 1);
      open_.push_back(left);
    } else if (index != last_hit_ || tree_.node(index).piece == kNoPiece) {
      const double here = gap_to_node(index);
      if (here < 0.0) {
        last_hit_ = index;
        return kCollides;
      }
      least = std::min(least, here);
    }
  }
  return least;
}

// Negative if the boxes overlap.
double CollisionHint::gap_to_box(const TreeNode& node) const {
  return std::max(std::max(low_.x - node.high.x, node.low.x - high_.x),
                  std::max(low_.y - node.high.y, node.low.y - high_.y));
}

// The node has no children. A node that was hit before may have been decomposed since; then it is
// neither a piece nor a whole polygon, and counts as not hit.
double CollisionHint::gap_to_node(const std::uint32_t index) {
  const std::uint32_t piece = tree_.node(index).piece;
  if (piece != kNoPiece) return gap_to_piece(tree_.piece(piece));
  const auto polygon = tree_.whole_polygon(index);
  return polygon ? gap_to_polygon(*polygon) : INFINITY;
}

double CollisionHint::gap_to_polygon(const std::uint32_t polygon) {
  std::optional<EdgeRuns>& edges = edges_[polygon];
  if (!edges) edges.emplace(all_obstacles(problem_).polygon(polygon), problem_.frame);
  work_ += edges->count();
  const double least =
      edges->gap(low_, high_, [&](const Vec2 p, const Vec2 q) { return crosses(p, q); });
  if (least < 0.0) return kCollides;
  // No edge in the robot: each of its polygons lies inside or outside as a whole.
  const Robot& robot = problem_.robot;
  for (std::size_t i = 0; i < robot.body_pieces(); ++i) {
    if (i > 0 && robot.polygon_of_piece[i] == robot.polygon_of_piece[i - 1]) continue;
    work_ += edges->count();
    if (edges->contains(t_ + pdg::rotate(rotation_, robot.pieces[i].inner_centre)))
      return kCollides;
  }
  return least;
}

// Does the line from p to q enter a piece of the robot? In the robot's frame.
bool CollisionHint::crosses(const Vec2 p, const Vec2 q) {
  ++work_;
  const pdg::Rotation back{rotation_.cos, -rotation_.sin};
  const Vec2 a = pdg::rotate(back, p - t_);
  const Vec2 b = pdg::rotate(back, q - t_);
  const Vec2 normal{b.y - a.y, a.x - b.x};
  const double height = dot(normal, a);
  const double length = pdg::norm(normal);
  const auto meets_piece = [&](const pdg::ConvexPiece& piece) {
    ++work_;
    const double at = dot(normal, piece.centre) - height;
    if (std::abs(at) >= piece.radius * length) return false;
    bool left = false;
    bool right = false;
    for (const pdg::Edge& edge : piece.edges) {
      if (dot(edge.normal, a) >= edge.offset && dot(edge.normal, b) >= edge.offset) return false;
      (dot(normal, edge.vertex) > height ? right : left) = true;
    }
    return left && right;
  };
  const auto& pieces = problem_.robot.pieces;
  return std::any_of(pieces.begin(), pieces.end() - 1, meets_piece);
}

void CollisionHint::place_hull() {
  low_ = {INFINITY, INFINITY};
  high_ = {-INFINITY, -INFINITY};
  work_ += problem_.robot.pieces.back().edges.size();
  for (const pdg::Edge& edge : problem_.robot.pieces.back().edges) {
    const Vec2 p = pdg::rotate(rotation_, edge.vertex);
    low_ = {std::min(low_.x, p.x), std::min(low_.y, p.y)};
    high_ = {std::max(high_.x, p.x), std::max(high_.y, p.y)};
  }
  low_ = low_ + t_;
  high_ = high_ + t_;
}

// The distance of the reference point from the edge of its domain.
double CollisionHint::gap_to_domain() const {
  const Domain& d = problem_.domain;
  const Vec2 place = t_ - d.low;
  return std::min(std::min(place.x, d.size.x - place.x), std::min(place.y, d.size.y - place.y));
}

double CollisionHint::gap_to_walls() const {
  double least = INFINITY;
  for (const pdg::ConvexPiece& wall : problem_.walls) {  // the half-plane behind its normal
    const Vec2 n = wall.edges[0].normal;
    const Vec2 nearest{n.x > 0.0 ? low_.x : high_.x, n.y > 0.0 ? low_.y : high_.y};
    least = std::min(least, dot(n, nearest) - wall.edges[0].offset);
  }
  return least;
}

// The piece that blocked the last configuration often blocks this one, so it is asked first.
double CollisionHint::gap_to_last_piece() {
  if (last_hit_ == kNoPiece) return INFINITY;
  const std::uint32_t piece = tree_.node(last_hit_).piece;
  return piece == kNoPiece ? INFINITY : gap_to_piece(tree_.piece(piece));
}

double CollisionHint::gap_to_piece(const pdg::ConvexPiece& obstacle) {
  const Robot& robot = problem_.robot;
  work_ += robot.body_pieces();
  double least = INFINITY;
  for (std::size_t i = 0; i < robot.body_pieces(); ++i) {
    const pdg::ConvexPiece& a = robot.pieces[i];
    const double apart = pdg::norm(t_ + pdg::rotate(rotation_, a.centre) - obstacle.centre) -
                         (a.radius + obstacle.radius);
    if (apart >= least) continue;
    if (apart >= 0.0) {
      least = apart;
      continue;
    }
    const Vec2 apart_inside = t_ + pdg::rotate(rotation_, a.inner_centre) - obstacle.inner_centre;
    const double inner_reach = a.inner_radius + obstacle.inner_radius;
    if (dot(apart_inside, apart_inside) < inner_reach * inner_reach) return kCollides;
    turn(i);
    const double separated = separation(i, obstacle);
    if (separated < 0.0) return kCollides;
    least = std::min(least, separated);
  }
  return least;
}

void CollisionHint::turn(const std::size_t piece) {
  if (turned_at_[piece] == calls_) return;
  turned_at_[piece] = calls_;
  std::size_t k = problem_.robot.first_vertex[piece];
  for (const pdg::Edge& edge : problem_.robot.pieces[piece].edges) {
    vertices_[k] = pdg::rotate(rotation_, edge.vertex);
    normals_[k] = pdg::rotate(rotation_, edge.normal);
    ++k;
  }
}

// By the first axis that separates them; kCollides if there is none.
double CollisionHint::separation(const std::size_t piece, const pdg::ConvexPiece& b) {
  const std::vector<pdg::Edge>& edges = problem_.robot.pieces[piece].edges;
  work_ += edges.size() * b.edges.size();
  const std::size_t first = problem_.robot.first_vertex[piece];
  const std::size_t end = first + edges.size();
  for (const pdg::Edge& edge : b.edges) {
    const double least = edge.offset - dot(edge.normal, t_);
    double lowest = INFINITY;
    for (std::size_t k = first; k < end && lowest >= least; ++k)
      lowest = std::min(lowest, dot(edge.normal, vertices_[k]));
    if (lowest >= least) return lowest - least;
  }
  for (std::size_t k = first; k < end; ++k) {
    const double least = edges[k - first].offset + dot(normals_[k], t_);
    double lowest = INFINITY;
    for (std::size_t i = 0; i < b.edges.size() && lowest >= least; ++i)
      lowest = std::min(lowest, dot(normals_[k], b.edges[i].vertex));
    if (lowest >= least) return lowest - least;
  }
  return kCollides;
}

}  // namespace planner
