#include "separating_edges.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "pdg/native/tolerances.hpp"
#include "tuning.hpp"

namespace planner {

namespace {

bool meet(const Vec2 a_low, const Vec2 a_high, const Vec2 b_low, const Vec2 b_high,
          const double margin) {
  return a_low.x - margin < b_high.x && b_low.x - margin < a_high.x &&
         a_low.y - margin < b_high.y && b_low.y - margin < a_high.y;
}

// Lower bound of n . (R(theta_c + s w) p + t_c + s g) - n . t_c over |s| <= 1
// (docs/certificate.md).
double least_towards(const Vec2 n, const Vec2 p, const pdg::Motion& m) {
  const double h = m.half_angle;
  const double v = dot(n, p);
  const double w = cross(p, n);
  return v - std::abs(dot(n, m.g1) + w * m.turn) - std::max(v, 0.0) * (h * h / 2) -
         std::abs(w) * (h * h * h / 6);
}

// The same of R(s w) n . (u - s g).
double least_turning(const Vec2 n, const Vec2 u, const pdg::Motion& m) {
  const double h = m.half_angle;
  const double v = dot(n, u);
  const double w = cross(n, u);
  const double along = dot(n, m.g1);
  const double across = cross(n, m.g1);
  return v - std::abs(w * m.turn - along) - std::max(v, 0.0) * (h * h / 2) -
         std::abs(w) * (h * h * h / 6) - std::abs(along) * (h * h / 2) - std::abs(across) * h;
}

double obstacle_edge_least(const pdg::PosedPiece& a, const pdg::Edge& edge, const pdg::Motion& m) {
  double least = INFINITY;
  for (const Vec2 p : a.vertices) least = std::min(least, least_towards(edge.normal, p, m));
  return least + dot(edge.normal, m.t) - edge.offset;
}

double robot_edge_least(const pdg::PosedPiece& a, const std::size_t edge, const pdg::ConvexPiece& b,
                        const pdg::Motion& m) {
  double least = INFINITY;
  for (const pdg::Edge& other : b.edges)
    least = std::min(least, least_turning(a.normals[edge], other.vertex - m.t, m));
  return least - a.piece->edges[edge].offset;
}

}  // namespace

// One interval with the robot posed at its middle.
struct SeparatingEdges::Part {
  pdg::Motion motion;
  std::vector<Box> boxes;  // of the robot's pieces, swept
  Box whole;
};

namespace {

// Half-extents of a box about R(theta_c) a + t_c that holds vertex a during the motion: the better
// of two bounds along each axis, one of the translation and the turn by themselves, and one of
// their sum, whose second-order term is at most |a| h^2 / 2 (docs/certificate.md).
Vec2 sway_of(const Vec2 a, const Vec2 turned, const pdg::Motion& m) {
  const double length = std::abs(a.x) + std::abs(a.y);
  const double alone = m.half_angle * length;
  const double second = 0.5 * m.half_angle * m.half_angle * length;
  const Vec2 by{std::abs(m.g1.x - m.turn * turned.y), std::abs(m.g1.y + m.turn * turned.x)};
  return {std::min(std::abs(m.g1.x) + alone, by.x + second),
          std::min(std::abs(m.g1.y) + alone, by.y + second)};
}

}  // namespace

double box_margin(const ScaledProblem& problem, const Vec2 low, const Vec2 high) {
  const double farthest = std::max(std::max(std::abs(low.x), std::abs(high.x)),
                                   std::max(std::abs(low.y), std::abs(high.y)));
  return pdg::kSeparationErrorUnits * pdg::kUnitRoundoff *
         (problem.domain.reach + problem.robot.reach + 2.0 * farthest);
}

SweptBox swept_box(const ScaledProblem& problem, const ScaledConfiguration& from,
                   const ScaledConfiguration& to) {
  const pdg::Motion m = motion_along(problem, from, to, {0.0, 1.0});
  const pdg::Rotation rotation = rotation_at(between(from, to, 0.5).theta);
  SweptBox box{{INFINITY, INFINITY}, {-INFINITY, -INFINITY}};
  for (const pdg::Edge& edge : problem.robot.pieces.back().edges) {
    const Vec2 turned = pdg::rotate(rotation, edge.vertex);
    const Vec2 by = sway_of(edge.vertex, turned, m);
    const Vec2 p = turned + m.t;
    box.low = {std::min(box.low.x, p.x - by.x), std::min(box.low.y, p.y - by.y)};
    box.high = {std::max(box.high.x, p.x + by.x), std::max(box.high.y, p.y + by.y)};
  }
  return box;
}

std::optional<std::vector<ProvenInterval>> SeparatingEdges::prove(const ScaledConfiguration& from,
                                                                  const ScaledConfiguration& to) {
  from_ = from;
  to_ = to;
  proven_.clear();
  const SweptBox swept = swept_box(problem_, from, to);
  Nodes near;
  if (!tree_.empty()) gather(tree_.root(), {swept.low, swept.high}, false, near);
  if (!prove_part({0.0, 1.0}, near, 0)) return std::nullopt;
  return std::move(proven_);
}

// Appends what is not apart from the box by its own. Polygons are decomposed if `open` is set;
// false if one was left as it is.
bool SeparatingEdges::gather(const std::uint32_t index, const Box& swept, const bool open,
                             Nodes& out) {
  const TreeNode& node = tree_.node(index);
  const double margin = box_margin(problem_, node.low, node.high);
  if (!meet(node.low, node.high, swept.low, swept.high, margin)) return true;
  if (!open && tree_.whole_polygon(index)) {
    out.push_back(index);
    return false;
  }
  tree_.expand(index);
  if (tree_.node(index).piece != kNoPiece) {
    out.push_back(index);
    return true;
  }
  const std::uint32_t left = tree_.node(index).left;
  const bool all = gather(left, swept, open, out);
  return gather(left + 1, swept, open, out) && all;
}

SeparatingEdges::Part SeparatingEdges::make_part(const Interval interval) {
  Part part{motion_along(problem_, from_, to_, interval), {}, {}};
  const pdg::Motion& m = part.motion;
  posed_.turn_to(rotation_at(between(from_, to_, 0.5 * (interval.begin + interval.end)).theta));
  part.whole = {{INFINITY, INFINITY}, {-INFINITY, -INFINITY}};
  for (std::size_t i = 0; i < problem_.robot.body_pieces(); ++i) {
    const pdg::PosedPiece a = posed_.piece(i);
    Box box{{INFINITY, INFINITY}, {-INFINITY, -INFINITY}};
    for (std::size_t k = 0; k < a.vertices.size(); ++k) {
      const Vec2 p = a.vertices[k] + m.t;
      const Vec2 by = sway_of(a.piece->edges[k].vertex, a.vertices[k], m);
      box.low = {std::min(box.low.x, p.x - by.x), std::min(box.low.y, p.y - by.y)};
      box.high = {std::max(box.high.x, p.x + by.x), std::max(box.high.y, p.y + by.y)};
    }
    part.boxes.push_back(box);
    part.whole.low = {std::min(part.whole.low.x, box.low.x), std::min(part.whole.low.y, box.low.y)};
    part.whole.high = {std::max(part.whole.high.x, box.high.x),
                       std::max(part.whole.high.y, box.high.y)};
  }
  return part;
}

// A polygon whose box comes near on a long part often does so on no short one, so it is decomposed
// for short parts only.
bool SeparatingEdges::prove_part(const Interval interval, const Nodes& near, const int depth) {
  if (depth > kDeepestPart || proven_.size() >= kMostParts) return false;
  const Part part = make_part(interval);
  const pdg::Motion& m = part.motion;
  const double moves = pdg::norm(m.g1) + problem_.robot.reach * m.half_angle;
  const bool open = moves <= kShortPart * problem_.robot.reach;
  Nodes here;
  bool opened = true;
  for (const std::uint32_t node : near) opened = gather(node, part.whole, open, here) && opened;
  ProvenInterval proven{interval, {}, {}};
  // The expansion about the middle holds its error bound for small turns only.
  if (opened && m.half_angle <= pdg::kWidestCoupledTurn && within_walls(part) &&
      separate(part, here, proven)) {
    proven_.push_back(std::move(proven));
    return true;
  }
  const double middle = 0.5 * (interval.begin + interval.end);
  return prove_part({interval.begin, middle}, here, depth + 1) &&
         prove_part({middle, interval.end}, here, depth + 1);
}

bool SeparatingEdges::within_walls(const Part& part) {
  const pdg::PosedPiece hull = posed_.piece(problem_.robot.hull());
  for (std::uint32_t wall = 0; wall < tree_.wall_count(); ++wall) {
    const double error = separation_error(*hull.piece, tree_.piece(wall), part.motion);
    if (obstacle_edge_least(hull, tree_.piece(wall).edges[0], part.motion) < share_ * error)
      return false;
  }
  return true;
}

bool SeparatingEdges::separate(const Part& part, const Nodes& near, ProvenInterval& out) {
  const pdg::Motion& m = part.motion;
  for (const std::uint32_t node : near) {
    const std::uint32_t piece = tree_.node(node).piece;
    const pdg::ConvexPiece& b = tree_.piece(piece);
    Box box{b.edges[0].vertex, b.edges[0].vertex};
    for (const pdg::Edge& edge : b.edges) {
      box.low = {std::min(box.low.x, edge.vertex.x), std::min(box.low.y, edge.vertex.y)};
      box.high = {std::max(box.high.x, edge.vertex.x), std::max(box.high.y, edge.vertex.y)};
    }
    for (std::size_t i = 0; i < problem_.robot.body_pieces(); ++i) {
      const pdg::PosedPiece a = posed_.piece(i);
      const double error = separation_error(*a.piece, b, m);
      if (!meet(part.boxes[i].low, part.boxes[i].high, box.low, box.high, error)) continue;
      double best = -INFINITY;
      SeparatingEdge edge{piece, static_cast<std::uint16_t>(i), 0, pdg::EdgeOwner::kObstacle};
      const auto consider = [&](const pdg::EdgeOwner owner, const std::size_t k, const double at) {
        if (at <= best) return;
        best = at;
        edge.edge = static_cast<std::uint16_t>(k);
        edge.owner = owner;
      };
      for (std::size_t k = 0; k < b.edges.size(); ++k)
        consider(pdg::EdgeOwner::kObstacle, k, obstacle_edge_least(a, b.edges[k], m));
      for (std::size_t k = 0; k < a.normals.size(); ++k)
        consider(pdg::EdgeOwner::kRobot, k, robot_edge_least(a, k, b, m));
      if (best < share_ * error) return false;
      out.edges.push_back(edge);
    }
  }
  return true;
}

}  // namespace planner
