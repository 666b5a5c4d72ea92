#include "lattice.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace planner {

namespace {

__extension__ using Uint128 = unsigned __int128;

constexpr int kSignificantBits = std::numeric_limits<double>::digits;

// Exponent of the lowest bit that is set; value is not zero.
int lowest_bit(const double value) {
  int exponent = 0;
  const double fraction = std::frexp(std::abs(value), &exponent);
  const auto bits = static_cast<std::uint64_t>(std::ldexp(fraction, kSignificantBits));
  return exponent - kSignificantBits + __builtin_ctzll(bits);
}

struct Uint256 {
  Uint128 high = 0;
  Uint128 low = 0;
  friend constexpr auto operator<=>(const Uint256&, const Uint256&) = default;
};

Uint256 product(const Uint128 a, const Uint128 b) {
  constexpr unsigned half = 64;
  const auto low = [](const Uint128 v) {
    return static_cast<Uint128>(static_cast<std::uint64_t>(v));
  };
  const Uint128 a0 = low(a);
  const Uint128 a1 = a >> half;
  const Uint128 b0 = low(b);
  const Uint128 b1 = b >> half;
  const Uint128 inner = a1 * b0 + (a0 * b0 >> half);
  const Uint128 carried = low(inner) + a0 * b1;
  return {a1 * b1 + (inner >> half) + (carried >> half), (carried << half) | low(a0 * b0)};
}

struct SignedProduct {
  int sign;
  Uint256 size;
};

SignedProduct signed_product(const Int128 a, const Int128 b) {
  const auto size = [](const Int128 v) {
    return v < 0 ? -static_cast<Uint128>(v) : static_cast<Uint128>(v);
  };
  const int sign_a = (a > 0) - (a < 0);
  const int sign_b = (b > 0) - (b < 0);
  return {sign_a * sign_b, product(size(a), size(b))};
}

}  // namespace

std::optional<Lattice> common_lattice(const std::span<const double> values) {
  std::optional<int> lowest;
  int highest = std::numeric_limits<int>::min();  // every value lies below 2^highest
  for (const double value : values) {
    if (value == 0.0) continue;
    lowest = std::min(lowest.value_or(std::numeric_limits<int>::max()), lowest_bit(value));
    highest = std::max(highest, std::ilogb(value) + 1);
  }
  if (!lowest) return Lattice{};
  if (highest - *lowest > kLatticeBits) return std::nullopt;
  return Lattice{*lowest};
}

Int64 to_lattice(const Lattice& lattice, const double value) {
  return static_cast<Int64>(std::ldexp(value, -lattice.exponent));
}

std::optional<pdg::Vec2> to_user(const Lattice& lattice, const LatticePoint p) {
  if (double_below(p.x) != p.x || double_below(p.y) != p.y) return std::nullopt;
  return pdg::Vec2{std::ldexp(static_cast<double>(p.x), lattice.exponent),
                   std::ldexp(static_cast<double>(p.y), lattice.exponent)};
}

Int64 double_below(const Int64 value) {
  const std::uint64_t size =
      value < 0 ? -static_cast<std::uint64_t>(value) : static_cast<std::uint64_t>(value);
  const int bits =
      std::numeric_limits<std::uint64_t>::digits - (size == 0 ? 64 : __builtin_clzll(size));
  if (bits <= kSignificantBits) return value;
  const std::uint64_t unit = std::uint64_t{1} << static_cast<unsigned>(bits - kSignificantBits);
  const std::uint64_t rest = size % unit;
  if (rest == 0) return value;
  return value < 0 ? -static_cast<Int64>(size - rest + unit) : static_cast<Int64>(size - rest);
}

Int64 double_above(const Int64 value) {
  return -double_below(-value);
}

int compare_products(const Int128 a, const Int128 b, const Int128 c, const Int128 d) {
  const SignedProduct left = signed_product(a, b);
  const SignedProduct right = signed_product(c, d);
  if (left.sign != right.sign) return left.sign < right.sign ? -1 : 1;
  if (left.size == right.size) return 0;
  return (left.size < right.size) == (left.sign > 0) ? -1 : 1;
}

}  // namespace planner
