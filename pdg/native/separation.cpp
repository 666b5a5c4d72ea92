#include "separation.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace pdg {

namespace {

// Vertex ranges longer than this are not narrowed in one step; it bounds a stack buffer and
// nothing else (results do not depend on it beyond speed).
constexpr std::size_t kNarrowingBuffer = 512;

struct Envelope {
  double lo = 0.0;       // min over points and delta
  double hi = 0.0;       // upper bound of max over delta of min over points
  std::uint16_t first = 0;
  std::uint16_t count = 0;
};

// Half-extent of the translations along a fixed unit direction.
double fixed_extent(const Motion& m, const Vec2 n) {
  return std::abs(dot(n, m.g1)) + std::abs(dot(n, m.g2));
}

double turning_extent_of(const Motion& m, const Vec2 n, const Vec2 g, const double length) {
  const double v = std::abs(dot(n, g));
  const double w = std::abs(cross(n, g));
  if (w * m.cos_half <= v * m.sin_half) return length;
  return v * m.cos_half + w * m.sin_half;
}

// The same along a direction that turns with the robot.
double turning_extent(const Motion& m, const Vec2 n) {
  return turning_extent_of(m, n, m.g1, m.g1_length) + turning_extent_of(m, n, m.g2, m.g2_length);
}

// Trims the cyclic vertex range to those that can be minimal somewhere: lo_i <= min_j hi_j.
void narrow(const std::span<const double> lows, const double limit, const std::size_t ring,
            Envelope& envelope) {
  const std::size_t count = lows.size();
  std::size_t begin = 0;
  std::size_t length = count;
  if (count == ring) {  // whole ring: start behind the longest run of impossible vertices
    std::size_t best_run = 0;
    std::size_t best_end = 0;
    std::size_t run = 0;
    for (std::size_t i = 0; i < 2 * count; ++i) {
      run = lows[i % count] > limit ? run + 1 : 0;
      if (run > best_run && run < count) {
        best_run = run;
        best_end = i + 1;
      }
    }
    begin = best_end % count;
    length = count - best_run;
  } else {
    while (length > 1 && lows[begin] > limit) ++begin, --length;
    while (length > 1 && lows[begin + length - 1] > limit) --length;
  }
  envelope.first = static_cast<std::uint16_t>((envelope.first + begin) % ring);
  envelope.count = static_cast<std::uint16_t>(length);
}

// Lower envelope of n . R(delta) p_i (or R(delta) n . p_i: the sign of delta does not matter) over
// a cyclic vertex range. `point(i)` is vertex i seen from the centre of the motion;
// `aligned(i, value)` says whether the edge from vertex i to i + 1 becomes parallel to the axis
// within the half-angle and gives the envelope's value there.
template <class Point, class Aligned>
Envelope lower_envelope(const Vec2 n, const std::size_t ring, const Constraint& c, const Motion& m,
                        const double error, const Point& point, const Aligned& aligned) {
  Envelope out{.lo = INFINITY, .hi = INFINITY, .first = c.first, .count = c.count};
  std::array<double, kNarrowingBuffer> lows;
  double at_ends[2] = {INFINITY, INFINITY};
  double peak = -INFINITY;
  for (std::size_t i = 0; i < c.count; ++i) {
    std::size_t k = c.first + i;
    if (k >= ring) k -= ring;
    const Vec2 p = point(k);
    const double v = dot(n, p);
    const double w = cross(p, n);
    const double middle = v * m.cos_half;
    const double swing = w * m.sin_half;
    const double flat = std::abs(w) * m.cos_half;
    double lo = middle - std::abs(swing);
    double hi = middle + std::abs(swing);
    if (flat <= std::abs(v) * m.sin_half) {
      const double radius = norm(p);
      if (v > 0.0) {
        hi = radius;
        peak = std::max(peak, radius);
      } else {
        lo = -radius;
      }
    }
    at_ends[0] = std::min(at_ends[0], middle - swing);
    at_ends[1] = std::min(at_ends[1], middle + swing);
    out.lo = std::min(out.lo, lo);
    out.hi = std::min(out.hi, hi);
    if (i < kNarrowingBuffer) lows[i] = lo;
  }
  if (c.count == 1) return out;
  const double limit = out.hi + error;
  double envelope = std::max({at_ends[0], at_ends[1], peak});
  for (std::size_t i = 0; i + (c.count == ring ? 0 : 1) < c.count; ++i) {
    std::size_t k = c.first + i;
    if (k >= ring) k -= ring;
    double value = 0.0;
    if (aligned(k, value)) envelope = std::max(envelope, value);
  }
  out.hi = std::min(out.hi, envelope);
  if (c.count <= kNarrowingBuffer) narrow({lows.data(), c.count}, limit, ring, out);
  return out;
}

// Antiparallel within the half-angle.
bool opposes(const Vec2 a, const Vec2 b, const Motion& m) {
  return dot(a, b) <= kAlignmentSlack && std::abs(cross(a, b)) <= m.sin_half + kAlignmentSlack;
}

Range obstacle_edge_range(const PosedPiece& a, const ConvexPiece& b, const Motion& m,
                          const double error, Constraint& c) {
  const Edge& edge = b.edges[c.edge];
  const Vec2 n = edge.normal;
  const Envelope e = lower_envelope(
      n, a.vertices.size(), c, m, error, [&](const std::size_t k) { return a.vertices[k]; },
      [&](const std::size_t k, double& value) {
        value = -a.piece->edges[k].offset;
        return opposes(a.normals[k], n, m);
      });
  c.first = e.first;
  c.count = e.count;
  const double shift = dot(n, m.t) - edge.offset;
  const double extent = fixed_extent(m, n);
  return {e.lo + shift - extent, e.hi + shift + extent};
}

Range robot_edge_range(const PosedPiece& a, const ConvexPiece& b, const Motion& m,
                       const double error, Constraint& c) {
  const Vec2 n = a.normals[c.edge];
  const Envelope e = lower_envelope(
      n, b.edges.size(), c, m, error,
      [&](const std::size_t k) { return b.edges[k].vertex - m.t; },
      [&](const std::size_t k, double& value) {
        const Edge& edge = b.edges[k];
        value = dot(edge.normal, m.t) - edge.offset;
        return opposes(edge.normal, n, m);
      });
  c.first = e.first;
  c.count = e.count;
  const double offset = a.piece->edges[c.edge].offset;
  const double extent = turning_extent(m, n);
  return {e.lo - offset - extent, e.hi - offset + extent};
}

// Upper bound of the function's hi from the inner circle of the piece that the edge faces: enough to
// drop most edges of large pieces without a look at the vertices.
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
  Range range{middle - swing, middle + swing};
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
  for (Constraint c : active) {
    ++evaluations;
    if (c.count >= kQuickVertices && quick_high(a, b, motion, c) < -error) continue;
    const Range range = constraint_range(a, b, motion, error, c);
    if (range.lo >= error) {
      remaining.resize(before);
      return {PairLabel::kApart, range.lo - error, 0.0};
    }
    centre = std::max(centre, 0.5 * (range.lo + range.hi));
    if (range.hi >= -error) remaining.push_back(c);
  }
  const bool overlap = remaining.size() == before;
  return {overlap ? PairLabel::kOverlap : PairLabel::kUndecided, 0.0, centre};
}

}  // namespace pdg
