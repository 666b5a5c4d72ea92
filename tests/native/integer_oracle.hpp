// Exact oracles on integer coordinates, independent of the predicates under test.
#pragma once

#include <cstdint>
#include <vector>

#include "pdg/native/geometry/polygon.hpp"

namespace oracle {

// Coordinates below 2^20 in magnitude: products of differences fit 64 bits, rationals 128.
struct Point {
  std::int64_t x;
  std::int64_t y;
};
__extension__ using Wide = __int128;

inline Point integer(const pdg::Vec2 p) {
  return {static_cast<std::int64_t>(p.x), static_cast<std::int64_t>(p.y)};
}

inline std::int64_t side(const Point a, const Point b, const Point c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

inline std::int64_t twice_signed_area(const pdg::Ring& ring) {
  std::int64_t sum = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point a = integer(ring[i]);
    const Point b = integer(ring[(i + 1) % ring.size()]);
    sum += a.x * b.y - a.y * b.x;
  }
  return sum;
}

inline bool strictly_convex(const pdg::ConvexPolygon& piece) {
  const std::size_t n = piece.size();
  if (n < 3) return false;
  for (std::size_t i = 0; i < n; ++i) {
    // Every other vertex strictly left of every edge.
    const Point a = integer(piece[i]);
    const Point b = integer(piece[(i + 1) % n]);
    for (std::size_t k = 2; k < n; ++k) {
      if (side(a, b, integer(piece[(i + k) % n])) <= 0) return false;
    }
  }
  return true;
}

// A bound on a parameter t as numerator / denominator, denominator > 0.
struct Rational {
  std::int64_t num;
  std::int64_t den;
};
inline bool less(const Rational a, const Rational b) {
  return static_cast<Wide>(a.num) * b.den < static_cast<Wide>(b.num) * a.den;
}

// Whether the closed segment a b meets the open interior of the convex piece.
inline bool meets_interior(const Point a, const Point b, const pdg::ConvexPolygon& piece) {
  Rational low{-1, 1};
  Rational high{2, 1};
  for (std::size_t i = 0; i < piece.size(); ++i) {
    const Point p = integer(piece[i]);
    const Point q = integer(piece[(i + 1) % piece.size()]);
    const std::int64_t at_a = side(p, q, a);
    const std::int64_t at_b = side(p, q, b);
    if (at_a == at_b) {
      if (at_a <= 0) return false;
    } else if (at_b > at_a) {
      const Rational bound{-at_a, at_b - at_a};
      if (less(low, bound)) low = bound;
    } else {
      const Rational bound{at_a, at_a - at_b};
      if (less(bound, high)) high = bound;
    }
  }
  return less(low, high) && less(low, {1, 1}) && less({0, 1}, high);
}

// Even-odd rule; the point is given as scaled / scale and lies on no edge.
inline bool inside(const pdg::Polygon& polygon, const Point scaled, const std::int64_t scale) {
  bool odd = false;
  for (const pdg::Ring& ring : polygon.rings) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      Point a = integer(ring[i]);
      Point b = integer(ring[(i + 1) % ring.size()]);
      a = {a.x * scale, a.y * scale};
      b = {b.x * scale, b.y * scale};
      if ((a.y > scaled.y) == (b.y > scaled.y)) continue;
      const bool upward = b.y > a.y;
      const std::int64_t s = side(a, b, scaled);
      if (upward ? s > 0 : s < 0) odd = !odd;
    }
  }
  return odd;
}

// Whether the convex piece lies inside the polygon (even-odd rule).
inline bool inside(const pdg::Polygon& polygon, const pdg::ConvexPolygon& piece) {
  Point sum{0, 0};
  for (const pdg::Vec2 v : piece) sum = {sum.x + integer(v).x, sum.y + integer(v).y};
  for (const pdg::Ring& ring : polygon.rings) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Point b = integer(ring[(i + 1) % ring.size()]);
      if (meets_interior(integer(ring[i]), b, piece)) return false;
    }
  }
  return inside(polygon, sum, static_cast<std::int64_t>(piece.size()));
}

}  // namespace oracle
