#include "separation.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "lower_envelope.hpp"
#include "tuning.hpp"

namespace pdg {

namespace {

double turning_extent_of(const Motion& m, const Vec2 n, const Vec2 g) {
  const double v = std::abs(dot(n, g));
  const double w = std::abs(cross(n, g));
  if (w * m.cos_half <= v * m.sin_half) return norm(g);
  return v * m.cos_half + w * m.sin_half;
}

// Half-extent of the translations along a unit direction that turns with the robot.
double turning_extent(const Motion& m, const Vec2 n) {
  // The rectangle's extent along any direction is that of one of its diagonals.
  return std::max(turning_extent_of(m, n, m.g1 + m.g2), turning_extent_of(m, n, m.g1 - m.g2));
}

// Antiparallel within the half-angle.
bool opposes(const Vec2 a, const Vec2 b, const Motion& m) {
  return dot(a, b) <= kAlignmentSlack && std::abs(cross(a, b)) <= m.sin_half + kAlignmentSlack;
}

// Range of one function along a straight segment, where the angle follows the translation:
// t = t_c + s g1, delta = s turn, |s| <= 1. First order exactly, the rest bounded, so that the
// slack shrinks with the square of the interval. `point` as in lower_envelope; `slope(p)` is ds's
// derivative, `bend` bounds a further second-order term.
template <class Point, class Slope>
Range coupled_range(const Vec2 n, const std::size_t ring, const Constraint& c, const Motion& m,
                    const double bend, const Point& point, const Slope& slope) {
  const double h = m.half_angle;
  Range range{INFINITY, INFINITY, 0.0};
  for (std::size_t i = 0; i < c.count; ++i) {
    const Vec2 p = point(cyclic(c.first + i, ring));
    const double v = dot(n, p);
    const double w = cross(p, n);
    // 1 - cos h <= h^2 / 2 and h - sin h <= h^3 / 6
    const double rest = std::abs(v) * (h * h / 2) + std::abs(w) * (h * h * h / 6) + bend;
    const double reach = std::abs(slope(w)) + rest;
    range.lo = std::min(range.lo, v - reach);
    range.hi = std::min(range.hi, v + reach);
  }
  return range;
}

bool coupled_turn(const Motion& m) {
  return m.turn != 0.0 && m.half_angle <= kWidestCoupledTurn;
}

Range intersection(const Range a, const Range b) {
  return {std::max(a.lo, b.lo), std::min(a.hi, b.hi), a.turning};
}

Range obstacle_edge_range(const PosedPiece& a, const ConvexPiece& b, const Motion& m,
                          const double error, Constraint& c) {
  const Edge& edge = b.edges[c.edge];
  const Vec2 n = edge.normal;
  const auto point = [&](const std::size_t k) { return a.vertices[k]; };
  const Constraint whole = c;
  const Envelope e = lower_envelope(n, a.vertices.size(), c, m, error, point,
                                    [&](const std::size_t k, double& value) {
                                      value = -a.piece->edges[k].offset;
                                      return opposes(a.normals[k], n, m);
                                    });
  c.first = e.first;
  c.count = e.count;
  const double shift = dot(n, m.t) - edge.offset;
  const double extent = extent_along(m, n);
  const Range box{e.lo + shift - extent, e.hi + shift + extent, 0.5 * (e.hi - e.lo)};
  if (!coupled_turn(m)) return box;
  const double along = dot(n, m.g1);
  const Range coupled = coupled_range(n, a.vertices.size(), whole, m, 0.0, point,
                                      [&](const double w) { return along + w * m.turn; });
  return intersection(box, {coupled.lo + shift, coupled.hi + shift, 0.0});
}

Range robot_edge_range(const PosedPiece& a, const ConvexPiece& b, const Motion& m,
                       const double error, Constraint& c) {
  const Vec2 n = a.normals[c.edge];
  const auto point = [&](const std::size_t k) { return b.edges[k].vertex - m.t; };
  const Constraint whole = c;
  const Envelope e = lower_envelope(n, b.edges.size(), c, m, error, point,
                                    [&](const std::size_t k, double& value) {
                                      const Edge& edge = b.edges[k];
                                      value = dot(edge.normal, m.t) - edge.offset;
                                      return opposes(edge.normal, n, m);
                                    });
  c.first = e.first;
  c.count = e.count;
  const double offset = a.piece->edges[c.edge].offset;
  const double extent = turning_extent(m, n);
  const Range box{e.lo - offset - extent, e.hi - offset + extent, 0.5 * (e.hi - e.lo)};
  if (!coupled_turn(m)) return box;
  // R(delta) n . (u - s g1): u turns the other way round, and |(R(delta) n - n) . g1| <= h |g1|.
  const double along = dot(n, m.g1);
  const Range coupled = coupled_range(n, b.edges.size(), whole, m, m.half_angle * m.g1_length,
                                      point, [&](const double w) { return -along - w * m.turn; });
  return intersection(box, {coupled.lo - offset, coupled.hi - offset, 0.0});
}

// Upper bound of the function's hi from the inner circle of the piece that the edge faces: enough
// to drop most edges of large pieces without a look at the vertices.
double quick_high(const PosedPiece& a, const ConvexPiece& b, const Motion& m, const Constraint& c) {
  if (c.owner == EdgeOwner::kObstacle) {
    const Edge& edge = b.edges[c.edge];
    return dot(edge.normal, a.inner_centre + m.t) - edge.offset - a.piece->inner_radius +
           a.piece->reach * m.half_angle + extent_along(m, edge.normal);
  }
  const Vec2 n = a.normals[c.edge];
  const Vec2 u = b.inner_centre - m.t;
  const double v = dot(n, u);
  return std::max(v, v * m.cos_half) + std::abs(cross(u, n)) * m.sin_half -
         a.piece->edges[c.edge].offset - b.inner_radius + m.g1_length + m.g2_length;
}

}  // namespace

Range sinusoid_range(const double v, const double w, const Motion& m) {
  const double middle = v * m.cos_half;
  const double swing = std::abs(w) * m.sin_half;
  Range range{middle - swing, middle + swing, 0.0};
  if (std::abs(w) * m.cos_half <= std::abs(v) * m.sin_half) {
    const double radius = std::sqrt(v * v + w * w);
    (v > 0.0 ? range.hi : range.lo) = v > 0.0 ? radius : -radius;
  }
  return range;
}

Range constraint_range(const PosedPiece& a, const ConvexPiece& b, const Motion& motion,
                       const double error, Constraint& constraint) {
  return constraint.owner == EdgeOwner::kObstacle
             ? obstacle_edge_range(a, b, motion, error, constraint)
             : robot_edge_range(a, b, motion, error, constraint);
}

void all_constraints(const ConvexPiece& a, const ConvexPiece& b, std::vector<Constraint>& out) {
  const auto na = static_cast<std::uint16_t>(a.vertex_count);
  const auto nb = static_cast<std::uint16_t>(b.vertex_count);
  for (std::size_t k = 0; k < b.edges.size(); ++k)
    out.push_back({static_cast<std::uint16_t>(k), 0, na, EdgeOwner::kObstacle, 0});
  if (nb == 0) return;  // a half-plane is separated by its own normal or not at all
  for (std::size_t k = 0; k < a.edges.size(); ++k)
    out.push_back({static_cast<std::uint16_t>(k), 0, nb, EdgeOwner::kRobot, 0});
}

PairVerdict judge_pair(const PosedPiece& a, const ConvexPiece& b, const Motion& motion,
                       const std::span<const Constraint> active, std::vector<Constraint>& remaining,
                       std::uint64_t& evaluations) {
  const double error = separation_error(*a.piece, b, motion);
  const std::size_t before = remaining.size();
  double centre = -INFINITY;
  double best = -INFINITY;
  std::size_t best_at = before;
  Sway sway;
  for (Constraint c : active) {
    ++evaluations;
    if (c.count >= kQuickVertices && quick_high(a, b, motion, c) < -error) continue;
    const Range range = constraint_range(a, b, motion, error, c);
    if (range.lo >= error + motion.margin) {
      remaining.resize(before);
      return {PairLabel::kApart, range.lo - error, 0.0, {}};
    }
    centre = std::max(centre, 0.5 * (range.lo + range.hi));
    if (range.hi < -error) continue;
    const Vec2 n = c.owner == EdgeOwner::kObstacle ? b.edges[c.edge].normal : a.normals[c.edge];
    sway.g1 += std::abs(dot(n, motion.g1));
    sway.g2 += std::abs(dot(n, motion.g2));
    sway.turn += range.turning;
    if (range.lo > best) {
      best = range.lo;
      best_at = remaining.size();
    }
    remaining.push_back(c);
  }
  // The likeliest separating axis first: smaller motions meet it at once.
  if (best_at > before) std::swap(remaining[before], remaining[best_at]);
  const bool overlap = remaining.size() == before;
  return {overlap ? PairLabel::kOverlap : PairLabel::kUndecided, 0.0, centre, sway};
}

}  // namespace pdg
