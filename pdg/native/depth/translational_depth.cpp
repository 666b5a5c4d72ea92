#include "translational_depth.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <stdexcept>
#include <utility>

#include "pdg/native/geometry/predicates.hpp"
#include "pdg/native/tolerances.hpp"
#include "polygon_distance.hpp"

namespace pdg {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

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

// One polygon's edge, and the other polygon's vertex that is deepest behind it or least far before
// it.
struct Axis {
  double separation = kInfinity;  // plain separating-axis function
  std::size_t deepest = 0;
};

// Stops early, with a value that is too large, once that is below `enough`. Begins with the vertex
// `start`: what is deepest behind one edge is most often deep behind the next.
Axis axis_of_edge(const PlacedOutline& owner, const std::size_t edge, const PlacedOutline& other,
                  const std::size_t start, const double enough) {
  const Vec2 u = owner.vertices[edge];
  const Vec2 normal = owner.normals[edge];
  const std::size_t m = other.vertices.size();
  Axis axis{kInfinity, start};
  for (std::size_t i = 0, w = start; i < m; ++i, w = w + 1 == m ? 0 : w + 1) {
    const double s = dot(normal, other.vertices[w] - u);
    if (s >= axis.separation) continue;
    axis = {s, w};
    if (s < enough) break;
  }
  return axis;
}

// The edge that faces the other polygon most: a good first guess of the greatest function.
std::size_t facing_edge(const PlacedOutline& owner, const Vec2 towards) {
  std::size_t best = 0;
  for (std::size_t k = 1; k < owner.normals.size(); ++k)
    if (dot(owner.normals[k], towards) > dot(owner.normals[best], towards)) best = k;
  return best;
}

// Raises `separation` to the greatest plain function of the owner's edges; stops at one above
// `enough`.
void raise_separation(const PlacedOutline& owner, const PlacedOutline& other, const Vec2 towards,
                      const double enough, double& separation) {
  const std::size_t n = owner.vertices.size();
  if (n == 1) return;  // a point has no axis of its own
  const std::size_t first = facing_edge(owner, towards);
  std::size_t start = 0;
  for (std::size_t i = 0, k = first; i < n && separation <= enough;
       ++i, k = k + 1 == n ? 0 : k + 1) {
    const Axis axis = axis_of_edge(owner, k, other, start, separation);
    start = axis.deepest;
    separation = std::max(separation, axis.separation);
  }
}

// The shortest way out. Plain doubles leave out what cannot be it; what they cannot tell apart is
// compared by areas that are good to a few roundings of themselves.
struct Escape {
  double depth = kInfinity;
  bool edge_of_b = true;
  std::size_t edge = 0;
  Vec2 deepest;  // the other's vertex that is deepest behind the edge
};

void try_edges(const PlacedOutline& owner, const PlacedOutline& other, const bool owner_is_b,
               const double separation, const double error, Escape& best) {
  const std::size_t n = owner.vertices.size();
  if (n == 1) return;
  std::size_t start = 0;
  for (std::size_t k = 0; k < n; ++k) {
    const double enough = separation - 2.0 * error;
    const Axis axis = axis_of_edge(owner, k, other, start, enough);
    start = axis.deepest;
    if (axis.separation < enough) continue;
    const Vec2 u = owner.vertices[k];
    const Vec2 v = next_vertex(owner.vertices, k);
    double area = -kInfinity;
    Vec2 deepest;
    for (const Vec2 w : other.vertices) {
      if (dot(owner.normals[k], w - u) > axis.separation + 2.0 * error) continue;
      const double candidate = signed_area(u, v, w);
      if (candidate > area) area = candidate, deepest = w;
    }
    const double depth = area / std::hypot(v.x - u.x, v.y - u.y);
    if (depth < best.depth) best = {depth, owner_is_b, k, deepest};
  }
}

Escape shortest_escape(const PlacedOutline& a, const PlacedOutline& b, const double separation,
                       const double error) {
  Escape escape;
  try_edges(b, a, true, separation, error, escape);
  try_edges(a, b, false, separation, error, escape);
  return escape;
}

Vec2 unit_normal(const PlacedOutline& outline, const std::size_t edge) {
  return edge_normal(outline.vertices[edge], next_vertex(outline.vertices, edge));
}

// PD^t = - max over all separating-axis functions s; the direction is that function's normal.
TranslationalDepth along_escape(const PlacedOutline& a, const PlacedOutline& b,
                                const double separation, const double error) {
  const Escape escape = shortest_escape(a, b, separation, error);
  TranslationalDepth result;
  result.depth = escape.depth;
  const PlacedOutline& owner = escape.edge_of_b ? b : a;
  const Vec2 u = owner.vertices[escape.edge];
  const Vec2 v = next_vertex(owner.vertices, escape.edge);
  const Vec2 normal = unit_normal(owner, escape.edge);
  // The foot of the deepest vertex; for parallel edges it may have to be moved along them.
  const Vec2 foot = closest_on_segment(escape.deepest + escape.depth * normal, u, v);
  const Vec2 opposite = foot - escape.depth * normal;
  result.direction = escape.edge_of_b ? normal : -normal;
  result.on_b = escape.edge_of_b ? foot : opposite;
  result.on_a = escape.edge_of_b ? opposite : foot;
  return result;
}

// Disjoint interiors: the nearest points.
TranslationalDepth along_gap(const PlacedOutline& a, const PlacedOutline& b) {
  const NearestPoints nearest = polygon_distance(a, b);
  TranslationalDepth result;
  result.depth = -nearest.distance;
  result.on_a = nearest.vertex_of_a ? nearest.vertex : nearest.foot;
  result.on_b = nearest.vertex_of_a ? nearest.foot : nearest.vertex;
  result.direction = nearest.vertex_of_a ? nearest.away : -nearest.away;
  return result;
}

double axis_error(const PlacedOutline& a, const PlacedOutline& b) {
  const Box both = joined(a.box, b.box);
  const Vec2 extent = both.high - both.low;
  return kAxisErrorUnits * kUnitRoundoff * (extent.x + extent.y);
}

// Computed in plain doubles; any value above `enough` stands for the greatest.
double greatest_separation(const PlacedOutline& a, const PlacedOutline& b, const double enough) {
  const Vec2 towards_a = centre(a.box) - centre(b.box);
  double separation = -kInfinity;
  raise_separation(b, a, towards_a, enough, separation);
  raise_separation(a, b, -towards_a, enough, separation);
  return separation;
}

}  // namespace

PairState pair_state(const ConvexPolygon& a, const ConvexPolygon& b) {
  for (const auto& [owner, other] : {std::pair{&a, &b}, std::pair{&b, &a}}) {
    if (owner->size() == 1) continue;  // a point has no axis of its own
    for (std::size_t k = 0; k < owner->size(); ++k) {
      const auto state = judge_edge((*owner)[k], next_vertex(*owner, k), *other);
      if (state) return *state;
    }
  }
  return PairState::kOverlap;
}

TranslationalDepth translational_depth(const ConvexPolygon& a, const ConvexPolygon& b) {
  return translational_depth(make_outline(a), make_outline(b));
}

TranslationalDepth translational_depth(const PlacedOutline& a, const PlacedOutline& b) {
  const double error = axis_error(a, b);
  const double separation = greatest_separation(a, b, error);
  PairState state = PairState::kApart;
  if (separation < -error) {
    state = PairState::kOverlap;
  } else if (separation <= error) {
    state = pair_state(a.vertices, b.vertices);
  }
  TranslationalDepth result =
      state == PairState::kOverlap ? along_escape(a, b, separation, error) : along_gap(a, b);
  if (state == PairState::kTouching) {
    result.depth = 0.0;
    result.direction = along_escape(a, b, separation, error).direction;
  }
  result.state = state;
  result.direction = result.direction + Vec2{};  // no -0
  return result;
}

std::optional<TranslationalDepth> overlap_deeper_than(const ConvexPolygon& polygon_a,
                                                      const ConvexPolygon& polygon_b,
                                                      const double depth) {
  const PlacedOutline a = make_outline(polygon_a);
  const PlacedOutline b = make_outline(polygon_b);
  const double enough = axis_error(a, b) - depth;
  if (greatest_separation(a, b, enough) > enough) return std::nullopt;
  const TranslationalDepth result = translational_depth(a, b);
  if (result.state != PairState::kOverlap || result.depth <= depth) return std::nullopt;
  return result;
}

bool overlap_exactly(const ConvexPolygon& a, const ConvexPolygon& b) {
  for (const ConvexPolygon* polygon : {&a, &b})
    if (!std::all_of(polygon->begin(), polygon->end(), in_exact_range))
      throw std::invalid_argument("coordinate outside the range of exact arithmetic");
  return pair_state(a, b) == PairState::kOverlap;
}

TranslationalDepth translational_depth(const ConvexPolygon& a, const Pose& pose,
                                       const PlacedOutline& b, PlacedOutline& moved) {
  place_outline(a, pose, moved);
  return translational_depth(moved, b);
}

}  // namespace pdg
