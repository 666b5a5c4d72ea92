// Orientation by exact expansion arithmetic
// (Shewchuk, Adaptive Precision Floating-Point Arithmetic and Fast Robust Geometric Predicates).
// Needs IEEE doubles, rounding to nearest, and no contraction (-ffp-contract=off).
#include "predicates.hpp"

#include <array>
#include <cfloat>
#include <cmath>
#include <cstddef>
#include <limits>

namespace pdg {
namespace {

static_assert(std::numeric_limits<double>::is_iec559);
static_assert(FLT_EVAL_METHOD == 0,
              "doubles are computed as doubles: on 32-bit x86 with -mfpmath=sse");
#ifdef __FAST_MATH__
#error "-ffast-math voids every bound"
#endif

// An unevaluated exact sum hi + lo.
struct TwoTerms {
  double hi;
  double lo;
};

TwoTerms two_sum(const double a, const double b) {
  const double s = a + b;
  const double b_part = s - a;
  const double a_part = s - b_part;
  return {s, (a - a_part) + (b - b_part)};
}

TwoTerms two_product(const double a, const double b) {
  const double p = a * b;
  return {p, std::fma(a, b, -p)};
}

// A nonoverlapping expansion, components of increasing magnitude, zeros left out.
struct Expansion {
  std::array<double, 16> terms{};
  std::size_t size = 0;

  // Shewchuk's GROW-EXPANSION with zero elimination.
  void add(const double value) {
    double carry = value;
    std::size_t kept = 0;
    for (std::size_t i = 0; i < size; ++i) {
      const TwoTerms s = two_sum(carry, terms[i]);
      carry = s.hi;
      if (s.lo != 0.0) terms[kept++] = s.lo;
    }
    if (carry != 0.0) terms[kept++] = carry;
    size = kept;
  }

  // Adds sign * a * b, a and b two-term sums.
  void add_product(const TwoTerms a, const TwoTerms b, const double sign) {
    for (const double x : {a.lo, a.hi}) {
      for (const double y : {b.lo, b.hi}) {
        const TwoTerms p = two_product(sign * x, y);
        add(p.lo);
        add(p.hi);
      }
    }
  }

  // From the smallest on: the sum's relative error is below 2 u.
  double value() const {
    double sum = 0.0;
    for (std::size_t i = 0; i < size; ++i) sum += terms[i];
    return sum;
  }

  // The largest component decides the sign.
  int sign() const { return size == 0 ? 0 : (terms[size - 1] > 0.0 ? 1 : -1); }
};

Expansion determinant(const Vec2 a, const Vec2 b, const Vec2 c) {
  Expansion det;
  det.add_product(two_sum(a.x, -c.x), two_sum(b.y, -c.y), 1.0);
  det.add_product(two_sum(a.y, -c.y), two_sum(b.x, -c.x), -1.0);
  return det;
}

}  // namespace

int orient2d_exact(const Vec2 a, const Vec2 b, const Vec2 c) {
  return determinant(a, b, c).sign();
}

namespace {

// Below this the products' rounding is no longer relative to them.
constexpr double kSmallestProducts = 0x1p-960;
constexpr double kAcceptedShare = 1.0 / 3.0;

// left +- right is taken as it is where it does not cancel.
bool good_enough(const double value, const double left, const double right) {
  const double size = std::abs(left) + std::abs(right);
  return std::abs(value) >= kAcceptedShare * size && size >= kSmallestProducts;
}

}  // namespace

double signed_area(const Vec2 a, const Vec2 b, const Vec2 c) {
  const double left = (a.x - c.x) * (b.y - c.y);
  const double right = (a.y - c.y) * (b.x - c.x);
  if (good_enough(left - right, left, right)) return left - right;
  return determinant(a, b, c).value();
}

double dot_from(const Vec2 a, const Vec2 b, const Vec2 c) {
  const double left = (b.x - a.x) * (c.x - a.x);
  const double right = (b.y - a.y) * (c.y - a.y);
  if (good_enough(left + right, left, right)) return left + right;
  Expansion sum;
  sum.add_product(two_sum(b.x, -a.x), two_sum(c.x, -a.x), 1.0);
  sum.add_product(two_sum(b.y, -a.y), two_sum(c.y, -a.y), 1.0);
  return sum.value();
}

bool turns_left_or_straight(const Vec2 p, const Vec2 u, const Vec2 q) {
  const int turn = orient2d(p, u, q);
  return turn > 0 || (turn == 0 && passes_through(p, u, q));
}

bool in_exact_range(const Vec2 a) {
  const auto fits = [](const double v) {
    const double m = std::abs(v);
    return m == 0.0 || (m >= kMinCoordinate && m <= kMaxCoordinate);
  };
  return fits(a.x) && fits(a.y);
}

}  // namespace pdg
