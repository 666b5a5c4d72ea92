// Scene coordinates as integers: every double of the scene is an integer times one power of two, so
// that sums, products and signs of determinants are exact.
#pragma once

#include <compare>
#include <cstdint>
#include <optional>
#include <span>

#include "pdg/native/geometry/vec.hpp"

namespace planner {

using Int64 = std::int64_t;
__extension__ using Int128 = __int128;

// In units of the lattice: |x|, |y| < 2^61.
struct LatticePoint {
  Int64 x = 0;
  Int64 y = 0;
  friend constexpr auto operator<=>(const LatticePoint&, const LatticePoint&) = default;
};

constexpr LatticePoint operator+(const LatticePoint a, const LatticePoint b) {
  return {a.x + b.x, a.y + b.y};
}
constexpr LatticePoint operator-(const LatticePoint a, const LatticePoint b) {
  return {a.x - b.x, a.y - b.y};
}

// Differences of lattice points stay below 2^62, so that the determinant stays below 2^125.
constexpr Int128 cross(const LatticePoint a, const LatticePoint b) {
  return static_cast<Int128>(a.x) * b.y - static_cast<Int128>(a.y) * b.x;
}

// Positive if c lies to the left of the line from a to b.
constexpr Int128 orientation(const LatticePoint a, const LatticePoint b, const LatticePoint c) {
  return cross(b - a, c - a);
}

// One unit is 2^exponent of the user's length unit.
struct Lattice {
  int exponent = 0;
};

// Coordinates that fit have at most this many bits; a sum of two then fits a LatticePoint.
inline constexpr int kLatticeBits = 60;

// The coarsest lattice that holds all values exactly; empty if a value needs too many bits on it.
std::optional<Lattice> common_lattice(std::span<const double> values);

// `value` is one of the values that the lattice was made for.
Int64 to_lattice(const Lattice& lattice, double value);
inline LatticePoint to_lattice(const Lattice& lattice, const pdg::Vec2 p) {
  return {to_lattice(lattice, p.x), to_lattice(lattice, p.y)};
}

// The point in the user's unit; empty if one of its coordinates is no double.
std::optional<pdg::Vec2> to_user(const Lattice& lattice, LatticePoint p);

// The largest coordinate not above `value`, and the least one not below it, that is a double.
Int64 double_below(Int64 value);
Int64 double_above(Int64 value);

// sign(a b - c d), exactly.
int compare_products(Int128 a, Int128 b, Int128 c, Int128 d);

}  // namespace planner
