// Range of one separating-axis function's vertex term over the turns of a motion: the lower
// envelope of n . R(delta) p_i over a range of a ring's vertices, and which of them can be its
// minimum.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>

#include "pdg/native/geometry/motion.hpp"
#include "separation.hpp"

namespace pdg {

struct Envelope {
  double lo = 0.0;  // min over points and delta
  double hi = 0.0;  // upper bound of max over delta of min over points
  std::uint16_t first = 0;
  std::uint16_t count = 0;
};

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
inline Envelope single_vertex(const Vec2 n, const Constraint& c, const Motion& m, const Vec2 p) {
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

}  // namespace pdg
