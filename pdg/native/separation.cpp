#include "separation.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace pdg {

namespace {

struct Envelope {
  double lo = 0.0;  // min over points and delta
  double hi = 0.0;  // upper bound of max over delta of min over points
  std::uint16_t first = 0;
  std::uint16_t count = 0;
};

// Half-extent of the translations along a fixed unit direction.
double fixed_extent(const Motion& m, const Vec2 n) {
  return std::abs(dot(n, m.g1)) + std::abs(dot(n, m.g2));
}

double turning_extent_of(const Motion& m, const Vec2 n, const Vec2 g) {
  const double v = std::abs(dot(n, g));
  const double w = std::abs(cross(n, g));
  if (w * m.cos_half <= v * m.sin_half) return norm(g);
  return v * m.cos_half + w * m.sin_half;
}

// The same along a direction that turns with the robot.
double turning_extent(const Motion& m, const Vec2 n) {
  // The rectangle's extent along any direction is that of one of its diagonals.
  return std::max(turning_extent_of(m, n, m.g1 + m.g2), turning_extent_of(m, n, m.g1 - m.g2));
}

// Part of a constraint's cyclic vertex range.
struct Arc {
  std::size_t start;
  std::size_t length;
};

struct Least {
  std::size_t index;  // within the constraint's range
  double value;
};

// The place of `sum` in a cycle of `count`; sum < 2 count.
constexpr std::size_t cyclic(const std::size_t sum, const std::size_t count) {
  return sum < count ? sum : sum - count;
}

// The vertices that can be the minimiser somewhere in the motion. On a counter-clockwise ring the
// minimiser walks backwards while delta grows: they are the arc from that at +h to that at -h.
// Vertices that rounding cannot tell from one of these two count as such, so that none is lost.
template <class Point>
Arc minimisers(const Vec2 n, const std::size_t ring, const Constraint& c, const Motion& m,
               const double error, const Point& point, const Least plus, const Least minus) {
  const std::size_t count = c.count;
  const auto ties = [&](const std::size_t i) {
    const Vec2 p = point(cyclic(c.first + i, ring));
    const double middle = dot(n, p) * m.cos_half;
    const double swing = cross(p, n) * m.sin_half;
    return std::pair{middle + swing <= plus.value + error, middle - swing <= minus.value + error};
  };
  const auto ties_somewhere = [&](const std::size_t i) {
    const auto [at_plus, at_minus] = ties(i);
    return at_plus || at_minus;
  };
  if (count < ring) {  // holds the arc in order
    std::size_t start = 0;
    std::size_t end = count - 1;
    while (start < end && !ties_somewhere(start)) ++start;
    while (end > start && !ties_somewhere(end)) --end;
    return {start, end - start + 1};
  }
  std::size_t start = plus.index;
  std::size_t length = cyclic(minus.index + count - start, count) + 1;
  for (; length < count && ties_somewhere(cyclic(start + count - 1, count)); ++length)
    start = cyclic(start + count - 1, count);
  while (length < count && ties_somewhere(cyclic(start + length, count))) ++length;
  // Two vertices that tie at both ends may stand for the arc that leads round the other side.
  std::size_t everywhere = 0;
  for (std::size_t i = 0; length > 1 && i < length; ++i) {
    const auto [at_plus, at_minus] = ties(cyclic(start + i, count));
    if (at_plus && at_minus) ++everywhere;
  }
  return everywhere > 1 ? Arc{0, count} : Arc{start, length};
}

// n . R(delta) p for the only vertex that is left.
Envelope single_vertex(const Vec2 n, const Constraint& c, const Motion& m, const Vec2 p) {
  const double v = dot(n, p);
  const double w = cross(p, n);
  const double middle = v * m.cos_half;
  const double swing = std::abs(w * m.sin_half);
  Envelope out{.lo = middle - swing, .hi = middle + swing, .first = c.first, .count = 1};
  if (std::abs(w) * m.cos_half <= std::abs(v) * m.sin_half)
    (v > 0.0 ? out.hi : out.lo) = v > 0.0 ? norm(p) : -norm(p);
  return out;
}

// Lower envelope of n . R(delta) p_i over a cyclic vertex range (for a robot edge the angle runs
// the other way, which changes nothing). `point(i)` is vertex i seen from the centre of the motion;
// `aligned(i, value)` says whether the edge from vertex i to i + 1 becomes parallel to the axis
// within the half-angle and gives the envelope's value there.
template <class Point, class Aligned>
Envelope lower_envelope(const Vec2 n, const std::size_t ring, const Constraint& c, const Motion& m,
                        const double error, const Point& point, const Aligned& aligned) {
  if (c.count == 1) return single_vertex(n, c, m, point(c.first));
  Envelope out{.lo = INFINITY, .hi = INFINITY, .first = c.first, .count = c.count};
  const auto at = [&](const std::size_t i) { return cyclic(c.first + i, ring); };
  double at_minus = INFINITY;  // envelope at delta = -h and +h, and its minimisers there
  double at_plus = INFINITY;
  std::size_t i_minus = 0;
  std::size_t i_plus = 0;
  double peak = -INFINITY;
  for (std::size_t i = 0; i < c.count; ++i) {
    const std::size_t k = at(i);
    const Vec2 p = point(k);
    const double v = dot(n, p);
    const double w = cross(p, n);
    const double middle = v * m.cos_half;
    const double swing = w * m.sin_half;
    double lo = middle - std::abs(swing);
    double hi = middle + std::abs(swing);
    if (std::abs(w) * m.cos_half <= std::abs(v) * m.sin_half) {
      const double radius = norm(p);
      if (v > 0.0) {
        hi = radius;
        // The peak belongs to the envelope only if this vertex is the minimiser there, which on a
        // convex ring its neighbours decide.
        const Vec2 after = point(k + 1 == ring ? 0 : k + 1) - p;
        const Vec2 before = point(k == 0 ? ring - 1 : k - 1) - p;
        const auto not_below = [&](const Vec2 e) {
          return dot(p, e) >= -error * (radius + std::abs(e.x) + std::abs(e.y));
        };
        if (not_below(after) && not_below(before)) peak = std::max(peak, radius);
      } else {
        lo = -radius;
      }
    }
    if (middle - swing < at_minus) at_minus = middle - swing, i_minus = i;
    if (middle + swing < at_plus) at_plus = middle + swing, i_plus = i;
    out.lo = std::min(out.lo, lo);
    out.hi = std::min(out.hi, hi);
  }
  const Arc arc = minimisers(n, ring, c, m, error, point, {i_plus, at_plus}, {i_minus, at_minus});
  double envelope = std::max({at_minus, at_plus, peak});
  for (std::size_t i = 0; i + 1 < arc.length; ++i) {
    double value = 0.0;
    if (aligned(at(cyclic(arc.start + i, c.count)), value)) envelope = std::max(envelope, value);
  }
  out.hi = std::min(out.hi, envelope);
  out.first = static_cast<std::uint16_t>(at(arc.start));
  out.count = static_cast<std::uint16_t>(arc.length);
  return out;
}

// Antiparallel within the half-angle.
bool opposes(const Vec2 a, const Vec2 b, const Motion& m) {
  return dot(a, b) <= kAlignmentSlack && std::abs(cross(a, b)) <= m.sin_half + kAlignmentSlack;
}

// Range of one function along a straight segment, where the angle follows the translation:
// t = t_c + s g1, delta = s turn, |s| <= 1. First order exactly, the rest bounded, so that the
// slack shrinks with the square of the interval. `point` as above; `slope(p)` is ds's derivative,
// `bend` bounds a further second-order term.
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
  const double extent = fixed_extent(m, n);
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
           a.piece->reach * m.half_angle + fixed_extent(m, edge.normal);
  }
  const Vec2 n = a.normals[c.edge];
  const Vec2 u = b.inner_centre - m.t;
  const double v = dot(n, u);
  return std::max(v, v * m.cos_half) + std::abs(cross(u, n)) * m.sin_half -
         a.piece->edges[c.edge].offset - b.inner_radius + m.g1_length + m.g2_length;
}

// Below this many candidate vertices the full range costs no more than the quick bound.
constexpr std::uint16_t kQuickVertices = 3;

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
