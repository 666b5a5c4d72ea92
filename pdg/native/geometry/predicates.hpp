// Exact geometric predicates on doubles.
#pragma once

#include <cmath>

#include "vec.hpp"

namespace pdg {

// Nonzero coordinates must lie in [kMinCoordinate, kMaxCoordinate] in magnitude, so that no
// intermediate of orient2d under- or overflows: a coordinate is then a multiple of 2^-537, every
// product of two differences a multiple of 2^-1074, which doubles hold exactly. The gates that
// take polygons from outside check this range (triangulate, convex_pieces and the Python layer).
inline constexpr double kMinCoordinate = 0x1p-485;
inline constexpr double kMaxCoordinate = 0x1p500;

// Filter bound: with l = (ax - cx)(by - cy) and r = (ay - cy)(bx - cx), each difference and each
// product carries one relative rounding u = 2^-53 and their difference another, so
// |fl(l - r) - (l - r)| <= (3u + O(u^2)) (|fl l| + |fl r|); 16 u^2 covers the higher orders and
// the rounding of the bound itself (Shewchuk's ccwerrboundA).
inline constexpr double kOrientationFilter = (3.0 + 16.0 * 0x1p-53) * 0x1p-53;

// orient2d by expansions alone.
int orient2d_exact(Vec2 a, Vec2 b, Vec2 c);

// Sign of twice the signed area of the triangle (a, b, c): +1 when c is strictly left of the
// directed line a -> b, 0 when the three are exactly collinear, -1 when c is strictly right.
// True of the exact doubles given.
// Decided by a floating-point filter in most cases, else by exact expansion arithmetic.
inline int orient2d(const Vec2 a, const Vec2 b, const Vec2 c) {
  const double left = (a.x - c.x) * (b.y - c.y);
  const double right = (a.y - c.y) * (b.x - c.x);
  const double det = left - right;
  const double bound = kOrientationFilter * (std::abs(left) + std::abs(right));
  if (det > bound) return 1;
  if (-det > bound) return -1;
  return orient2d_exact(a, b, c);
}

// Twice the signed area of the triangle (a, b, c), with a relative error of at most
// kValueErrorUnits u: small values are as good as large ones, and 0 is exactly 0.
double signed_area(Vec2 a, Vec2 b, Vec2 c);

// (b - a) . (c - a), likewise.
double dot_from(Vec2 a, Vec2 b, Vec2 c);

// Three roundings of each product, of which the accepted difference is at least a third; its own.
inline constexpr double kValueErrorUnits = 10.0;

// Lexicographic order by (x, y); exact.
constexpr bool lexicographically_less(const Vec2 a, const Vec2 b) {
  return a.x < b.x || (a.x == b.x && a.y < b.y);
}

// For p, u, q exactly collinear and distinct from u: whether u lies between p and q.
constexpr bool passes_through(const Vec2 p, const Vec2 u, const Vec2 q) {
  return lexicographically_less(p, u) == lexicographically_less(u, q);
}

// Whether the turn p -> u -> q is to the left or goes straight on (never back on itself).
bool turns_left_or_straight(Vec2 p, Vec2 u, Vec2 q);

// Whether the coordinate range above holds; false for infinities and NaN.
bool in_exact_range(Vec2 a);

}  // namespace pdg
