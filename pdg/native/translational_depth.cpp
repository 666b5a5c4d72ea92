#include "translational_depth.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <stdexcept>

#include "predicates.hpp"

namespace pdg {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

Vec2 next_vertex(const ConvexPolygon& polygon, const std::size_t k) {
  return polygon[k + 1 == polygon.size() ? 0 : k + 1];
}

Vec2 outward_normal(const Vec2 u, const Vec2 v) {
  const double length = std::hypot(v.x - u.x, v.y - u.y);
  return {(v.y - u.y) / length, -((v.x - u.x) / length)};
}

Vec2 closest_on_segment(const Vec2 p, const Vec2 u, const Vec2 v) {
  const Vec2 along = v - u;
  const double t = dot(p - u, along) / dot(along, along);
  return u + std::clamp(t, 0.0, 1.0) * along;
}

// What the line through the edge u -> v of `owner` says, exactly: nothing if the other polygon has
// a vertex beyond it (inside), else apart or touching. All common points then lie on the line, on
// which the owner has the edge and the other the hull of its vertices there.
std::optional<PairState> judge_edge(const Vec2 u, const Vec2 v, const ConvexPolygon& other) {
  const Vec2 edge_low = std::min(u, v, lexicographically_less);
  const Vec2 edge_high = std::max(u, v, lexicographically_less);
  Vec2 low;
  Vec2 high;
  bool on_line = false;
  for (const Vec2 w : other) {
    const int side = orient2d(u, v, w);
    if (side > 0) return std::nullopt;
    if (side < 0) continue;
    low = on_line ? std::min(low, w, lexicographically_less) : w;
    high = on_line ? std::max(high, w, lexicographically_less) : w;
    on_line = true;
  }
  const bool meet =
      on_line && !lexicographically_less(high, edge_low) && !lexicographically_less(edge_high, low);
  return meet ? PairState::kTouching : PairState::kApart;
}

struct Axis {
  double separation = -kInfinity;  // min over the other's vertices, along the outward normal
  Vec2 normal;
  Vec2 u, v;     // the edge
  Vec2 deepest;  // the other's vertex that attains the minimum
};

// The separating-axis function of greatest value among the edges of `owner`; the first one found
// that reaches `enough`.
Axis best_axis(const ConvexPolygon& owner, const ConvexPolygon& other,
               const double enough = kInfinity) {
  Axis best;
  for (std::size_t k = 0; k < owner.size() && best.separation < enough; ++k) {
    Axis axis{kInfinity, {}, owner[k], next_vertex(owner, k), {}};
    axis.normal = outward_normal(axis.u, axis.v);
    for (const Vec2 w : other) {
      const double s = dot(axis.normal, w - axis.u);
      if (s < axis.separation) {
        axis.separation = s;
        axis.deepest = w;
      }
      if (s <= best.separation) break;
    }
    if (axis.separation > best.separation) best = axis;
  }
  return best;
}

// PD^t = - max over all separating-axis functions s; the direction is that function's normal.
TranslationalDepth depth_along(const Axis& of_a, const Axis& of_b) {
  TranslationalDepth result;
  if (of_b.separation >= of_a.separation) {
    result.depth = std::max(-of_b.separation, 0.0);
    result.direction = of_b.normal;
    // The foot of the deepest vertex; for parallel edges it may have to be moved along them.
    const Vec2 foot = of_b.deepest + result.depth * result.direction;
    result.on_b = closest_on_segment(foot, of_b.u, of_b.v);
    result.on_a = result.on_b - result.depth * result.direction;
  } else {
    result.depth = std::max(-of_a.separation, 0.0);
    result.direction = -of_a.normal;
    const Vec2 foot = of_a.deepest - result.depth * result.direction;
    result.on_a = closest_on_segment(foot, of_a.u, of_a.v);
    result.on_b = result.on_a + result.depth * result.direction;
  }
  return result;
}

TranslationalDepth overlap_depth(const ConvexPolygon& a, const ConvexPolygon& b) {
  return depth_along(best_axis(a, b), best_axis(b, a));
}

void require_exact_range(const ConvexPolygon& a, const ConvexPolygon& b) {
  for (const ConvexPolygon* polygon : {&a, &b}) {
    if (!std::all_of(polygon->begin(), polygon->end(), in_exact_range)) {
      throw std::invalid_argument("coordinate outside the range of exact arithmetic");
    }
  }
}

// Closest points of disjoint convex polygons: a vertex of one and an edge of the other.
TranslationalDepth gap(const ConvexPolygon& a, const ConvexPolygon& b) {
  TranslationalDepth result;
  double distance = kInfinity;
  const auto try_all = [&](const ConvexPolygon& vertices, const ConvexPolygon& edges,
                           const bool vertices_of_a) {
    for (const Vec2 w : vertices) {
      for (std::size_t k = 0; k < edges.size(); ++k) {
        const Vec2 foot = closest_on_segment(w, edges[k], next_vertex(edges, k));
        const double d = std::hypot(w.x - foot.x, w.y - foot.y);
        if (d >= distance) continue;
        distance = d;
        result.on_a = vertices_of_a ? w : foot;
        result.on_b = vertices_of_a ? foot : w;
      }
    }
  };
  try_all(a, b, true);
  try_all(b, a, false);
  result.depth = -distance;
  const Vec2 away = result.on_a - result.on_b;
  result.direction = distance > 0.0 ? (1.0 / distance) * away : Vec2{};
  return result;
}

}  // namespace

PairState pair_state(const ConvexPolygon& a, const ConvexPolygon& b) {
  for (const auto& [owner, other] : {std::pair{&a, &b}, std::pair{&b, &a}}) {
    for (std::size_t k = 0; k < owner->size(); ++k) {
      const auto state = judge_edge((*owner)[k], next_vertex(*owner, k), *other);
      if (state) return *state;
    }
  }
  return PairState::kOverlap;
}

TranslationalDepth translational_depth(const ConvexPolygon& a, const ConvexPolygon& b) {
  require_exact_range(a, b);
  const PairState state = pair_state(a, b);
  TranslationalDepth result = state == PairState::kOverlap ? overlap_depth(a, b) : gap(a, b);
  result.state = state;
  // Nearly touching: rounding may leave no distance to take the direction from.
  if (state == PairState::kTouching || result.direction == Vec2{}) {
    result.direction = overlap_depth(a, b).direction;
  }
  if (state == PairState::kTouching) result.depth = 0.0;
  result.direction = result.direction + Vec2{};  // no -0
  return result;
}

std::optional<TranslationalDepth> overlap_deeper_than(const ConvexPolygon& a,
                                                      const ConvexPolygon& b, const double depth) {
  require_exact_range(a, b);
  const Axis of_b = best_axis(b, a, -depth);
  if (of_b.separation >= -depth) return std::nullopt;
  const Axis of_a = best_axis(a, b, -depth);
  if (of_a.separation >= -depth || pair_state(a, b) != PairState::kOverlap) return std::nullopt;
  TranslationalDepth result = depth_along(of_a, of_b);
  result.state = PairState::kOverlap;
  result.direction = result.direction + Vec2{};  // no -0
  return result;
}

bool overlap_exactly(const ConvexPolygon& a, const ConvexPolygon& b) {
  require_exact_range(a, b);
  return pair_state(a, b) == PairState::kOverlap;
}

}  // namespace pdg
