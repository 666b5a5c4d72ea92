#include "star.hpp"

#include <algorithm>
#include <cmath>

#include "pdg/native/separation/separation.hpp"
#include "planar_planner/native/tolerances.hpp"

namespace planner {

using pdg::Constraint;
using pdg::ConvexPiece;
using pdg::EdgeOwner;
using pdg::Motion;
using pdg::PosedPiece;

namespace {

// sin h - h cos h; h^3/3 with a bound on the rest where the difference would cancel.
double sine_defect(const Motion& m) {
  const double h = m.half_angle;
  if (h < 0.125) return h * h * h / 3.0;  // sin h - h cos h = h^3/3 - h^5/30 + ...
  return m.sin_half - h * m.cos_half;
}

template <class Visit>
void for_each_vertex(const Constraint& c, const std::size_t ring, const Visit& visit) {
  for (std::size_t i = 0; i < c.count; ++i) {
    std::size_t k = c.first + i;
    if (k >= ring) k -= ring;
    visit(k);
  }
}

bool separates_at(const PosedPiece& a, const ConvexPiece& b, const Constraint& c, const Vec2 t,
                  const double error) {
  bool apart = true;
  if (c.owner == EdgeOwner::kObstacle) {
    const pdg::Edge& edge = b.edges[c.edge];
    const double level = edge.offset - dot(edge.normal, t) + error;
    for_each_vertex(c, a.vertices.size(), [&](const std::size_t k) {
      apart = apart && dot(edge.normal, a.vertices[k]) >= level;
    });
  } else {
    const Vec2 n = a.normals[c.edge];
    const double level = a.piece->edges[c.edge].offset + error;
    for_each_vertex(c, b.edges.size(), [&](const std::size_t k) {
      apart = apart && dot(n, b.edges[k].vertex - t) >= level;
    });
  }
  return apart;
}

// Sutherland-Hodgman. The planes are checked again at the guard itself, so rounding here costs at
// most a guard, never soundness.
bool add(StarScratch& s, const HalfPlane plane) {
  s.planes.push_back(plane);
  s.heights.clear();
  bool any_inside = false;
  bool all_inside = true;
  for (const Vec2 p : s.polygon) {
    s.heights.push_back(dot(plane.normal, p) - plane.offset);
    const bool inside = s.heights.back() > 0.0;
    any_inside = any_inside || inside;
    all_inside = all_inside && inside;
  }
  if (!any_inside) s.polygon.clear();
  if (!any_inside || all_inside) return any_inside;
  s.clipped.clear();
  for (std::size_t i = 0; i < s.polygon.size(); ++i) {
    const std::size_t next = i + 1 == s.polygon.size() ? 0 : i + 1;
    const Vec2 p = s.polygon[i];
    const double dp = s.heights[i];
    const double dq = s.heights[next];
    if (dp > 0.0) s.clipped.push_back(p);
    if ((dp > 0.0) != (dq > 0.0)) s.clipped.push_back(p + (dp / (dp - dq)) * (s.polygon[next] - p));
  }
  std::swap(s.polygon, s.clipped);
  return !s.polygon.empty();
}

void obstacle_edge(StarScratch& scratch, const Motion& m, const PosedPiece& a, const ConvexPiece& b,
                   const Constraint& c, const double error) {
  const pdg::Edge& edge = b.edges[c.edge];
  const Vec2 n = edge.normal;
  const double shift = dot(n, m.t) - edge.offset;
  const double extent = extent_along(m, n);
  const double k_factor = m.cos_half + m.half_angle * m.sin_half;
  const double s_factor = sine_defect(m);
  for_each_vertex(c, a.vertices.size(), [&](const std::size_t k) {
    const double v = dot(n, a.vertices[k]);
    const double w = cross(a.vertices[k], n);
    if (pdg::sinusoid_range(v, w, m).lo + shift - extent >= error) return;  // never crossed
    add(scratch, {n, edge.offset - std::min(v, v * k_factor) + std::abs(w) * s_factor + error});
  });
}

void robot_edge(StarScratch& scratch, const Motion& m, const PosedPiece& a, const ConvexPiece& b,
                const Constraint& c, const double error) {
  const Vec2 normal = a.normals[c.edge];
  const Vec2 along = pdg::perp(normal);
  const double offset = a.piece->edges[c.edge].offset;
  const double h = m.half_angle;
  const double k_factor = m.cos_half + h * m.sin_half;
  const double across_extent = extent_along(m, normal);
  const double along_extent = extent_along(m, along);
  // |M'(theta) . e| over the translations' deviations e, and the turn of M' applied to t_c - t_o.
  const double slide = along_extent + 2.0 * across_extent * m.sin_half;
  const double extent = across_extent + along_extent * m.sin_half;
  const double level = std::max(offset, offset / k_factor);
  const double s_factor = sine_defect(m);
  for_each_vertex(c, b.edges.size(), [&](const std::size_t k) {
    const Vec2 u = b.edges[k].vertex - m.t;
    const double v = dot(normal, u);
    const double w = dot(along, u);
    if (pdg::sinusoid_range(v, w, m).lo - extent - offset >= error) return;  // never crossed
    const double fixed = level + h * slide + (std::abs(w) + along_extent) * s_factor + error;
    // M . (b - t_o) > fixed + h |M' . (t_c - t_o)|, one half-plane for each sign.
    for (const double sign : {h, -h}) {
      const Vec2 p = -normal + sign * along;
      add(scratch, {p, fixed - dot(normal, b.edges[k].vertex) + sign * dot(along, m.t)});
      if (h == 0.0) break;
    }
  });
}

// Clips the polygon by the conditions of every active function; false if nothing is left of it.
bool collect(const ObstacleTree& tree, StarScratch& scratch, const Motion& motion,
             PosedRobot& posed, const ConstraintView& list) {
  std::size_t at = 0;
  for (const PairHeader& header : list.pairs) {
    const PosedPiece a = posed.piece(header.robot);
    const ConvexPiece& b = tree.piece(header.obstacle);
    const double error = kGuardErrorFactor * pdg::separation_error(*a.piece, b, motion);
    for (std::size_t i = 0; i < header.count; ++i) {
      const Constraint& c = list.constraints[at + i];
      if (c.owner == EdgeOwner::kObstacle)
        obstacle_edge(scratch, motion, a, b, c, error);
      else
        robot_edge(scratch, motion, a, b, c, error);
      if (scratch.polygon.empty()) return false;
    }
    at += header.count;
  }
  return true;
}

}  // namespace

bool is_free(const ObstacleTree& tree, PosedRobot& posed, const Vec2 t, const double reach,
             const ConstraintView& list, const double margin) {
  const Motion here = pdg::make_motion(t, {}, {}, {}, reach);
  std::size_t at = 0;
  for (const PairHeader& header : list.pairs) {
    if (closed(header)) return false;
    const PosedPiece a = posed.piece(header.robot);
    const ConvexPiece& b = tree.piece(header.obstacle);
    const double error = pdg::separation_error(*a.piece, b, here) + margin;
    bool apart = false;
    for (std::size_t i = 0; i < header.count && !apart; ++i)
      apart = separates_at(a, b, list.constraints[at + i], t, error);
    if (!apart) return false;
    at += header.count;
  }
  return true;
}

std::optional<Vec2> find_guard(const ObstacleTree& tree, const Motion& m, PosedRobot& posed,
                               const ConstraintView& list, StarScratch& scratch) {
  // A closed pair may be anywhere in the set.
  if (std::any_of(list.pairs.begin(), list.pairs.end(), closed)) return std::nullopt;
  scratch.planes.clear();
  scratch.polygon = {m.t - m.g1 - m.g2, m.t + m.g1 - m.g2, m.t + m.g1 + m.g2, m.t - m.g1 + m.g2};
  if (!collect(tree, scratch, m, posed, list)) return std::nullopt;
  Vec2 guard;
  for (const Vec2 p : scratch.polygon) guard = guard + p;
  guard = (1.0 / static_cast<double>(scratch.polygon.size())) * guard;
  for (const HalfPlane& plane : scratch.planes)
    if (!(dot(plane.normal, guard) > plane.offset)) return std::nullopt;
  if (!is_free(tree, posed, guard, m.reach, list)) return std::nullopt;
  return guard;
}

}  // namespace planner
