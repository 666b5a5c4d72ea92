// Ball arithmetic on IEEE quadruple precision: every Ball holds the real number that it stands for.
// Owes nothing to the core's evaluation. Only + - * / of the compiler's __float128 are used, which
// it rounds correctly; square roots and sines are made from them.
#pragma once

#if !defined(__SIZEOF_FLOAT128__)
#error "the rounding harness needs __float128 (GCC or Clang on x86-64)"
#endif

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>

namespace exact {

__extension__ using Wide = __float128;  // 113 bits

// Unit roundoff of Wide, doubled; and a factor that turns a sum or product of a few nonnegative
// doubles into an upper bound.
inline constexpr double kWideRoundoff = 0x1p-112;
inline constexpr double kUp = 1.0 + 0x1p-48;

inline Wide magnitude(const Wide x) {
  return x < 0 ? -x : x;
}

// Upper bound as a double.
inline double upper_double(const Wide x) {
  return static_cast<double>(magnitude(x)) * kUp + std::numeric_limits<double>::denorm_min();
}

struct Ball {
  Wide middle = 0;
  double radius = 0.0;

  Ball() = default;
  Ball(const double x) : middle(x) {}  // NOLINT: a double is an exact real
  Ball(const Wide m, const double r) : middle(m), radius(r) {}

  [[nodiscard]] bool certainly_negative() const { return middle < -static_cast<Wide>(radius); }
  [[nodiscard]] bool certainly_positive() const { return middle > static_cast<Wide>(radius); }
  [[nodiscard]] bool certainly_not_negative() const { return middle >= static_cast<Wide>(radius); }
  [[nodiscard]] bool possibly_not_negative() const { return !certainly_negative(); }
  [[nodiscard]] double value() const { return static_cast<double>(middle); }
};

inline Ball operator+(const Ball& a, const Ball& b) {
  const Wide m = a.middle + b.middle;
  return {m, (a.radius + b.radius + kWideRoundoff * upper_double(m)) * kUp};
}

inline Ball operator-(const Ball& a) {
  return {-a.middle, a.radius};
}

inline Ball operator-(const Ball& a, const Ball& b) {
  return a + -b;
}

inline Ball operator*(const Ball& a, const Ball& b) {
  const Wide m = a.middle * b.middle;
  const double spread = upper_double(a.middle) * b.radius + upper_double(b.middle) * a.radius +
                        a.radius * b.radius + kWideRoundoff * upper_double(m);
  return {m, spread * kUp};
}

// Infinite radius if b may be zero.
inline Ball operator/(const Ball& a, const Ball& b) {
  const Wide least = magnitude(b.middle) - static_cast<Wide>(b.radius) * kUp;
  if (!(least > 0)) return {0, std::numeric_limits<double>::infinity()};
  const Wide m = a.middle / b.middle;
  const Wide spread = (static_cast<Wide>(a.radius) + magnitude(m) * b.radius) / least;
  return {m, (upper_double(spread) + kWideRoundoff * upper_double(m)) * kUp};
}

// |x| and the least and largest of two: each changes by no more than its arguments do.
inline Ball absolute(const Ball& a) {
  return {magnitude(a.middle), a.radius};
}
inline Ball least(const Ball& a, const Ball& b) {
  return {a.middle < b.middle ? a.middle : b.middle, std::fmax(a.radius, b.radius)};
}
inline Ball greatest(const Ball& a, const Ball& b) {
  return {a.middle > b.middle ? a.middle : b.middle, std::fmax(a.radius, b.radius)};
}

// x 2^e, exactly.
inline Ball scaled(const Ball& a, const int e) {
  return {a.middle * static_cast<Wide>(std::ldexp(1.0, e)), std::ldexp(a.radius, e) * kUp};
}

// The number is not negative, whatever its ball says.
inline Ball square_root(const Ball& a) {
  const Wide top = a.middle + static_cast<Wide>(a.radius) * kUp;
  if (!(top > 0)) return {};
  // Newton's steps from a double; the residual bounds what is left of the error.
  const auto root = [](const Wide x) {
    Wide s = std::sqrt(static_cast<double>(x));
    for (int i = 0; i < 3; ++i) s = (s + x / s) / 2;
    return s;
  };
  if (a.middle - 2 * static_cast<Wide>(a.radius) <= 0) {
    const double reach = upper_double(root(top)) * kUp;
    return {static_cast<Wide>(reach) / 2, reach * 0.5 * kUp};
  }
  const Wide s = root(a.middle);
  const Wide residual = magnitude(s * s - a.middle) + 4 * kWideRoundoff * a.middle;
  return {s, upper_double((residual + static_cast<Wide>(a.radius)) / s) * kUp};
}

// pi as a sum of doubles, good to 2^-215.
inline constexpr std::array<double, 4> kPiParts{0x1.921fb54442d18p+1, 0x1.1a62633145c07p-53,
                                                -0x1.f1976b7ed8fbcp-109, 0x1.4cf98e804177dp-163};

inline Ball pi() {
  Wide sum = 0;
  for (const double part : kPiParts) sum += part;
  return {sum, 0x1p-109};
}

struct SineCosine {
  Ball sine, cosine;
};

// Taylor's series, |x| < 0.8. Terms beyond x^31 / 31! stay below 2^-123; Horner's scheme loses a
// few 2^-113, its factors being below 0.32.
inline SineCosine small_sine_cosine(const Ball& x) {
  const Wide square = x.middle * x.middle;
  Wide sine = 1;
  Wide cosine = 1;
  for (int k = 15; k >= 1; --k) {
    sine = 1 - square * sine / static_cast<Wide>(2 * k * (2 * k + 1));
    cosine = 1 - square * cosine / static_cast<Wide>(2 * k * (2 * k - 1));
  }
  const double radius = (x.radius + 0x1p-107) * kUp;
  return {{x.middle * sine, radius}, {cosine, radius}};
}

// The angle plus `quarters` quarter turns.
inline SineCosine turned(const SineCosine& a, const std::int64_t quarters) {
  switch (quarters & 3) {
    case 0:
      return a;
    case 1:
      return {a.cosine, -a.sine};
    case 2:
      return {-a.sine, -a.cosine};
    default:
      return {-a.cosine, a.sine};
  }
}

// The argument is a number of radians below 2^23 in magnitude that is exactly a Wide of at most 60
// fraction bits or smaller than a quarter turn; `radius` comes on top.
inline SineCosine sine_cosine(const Ball& x) {
  const Ball quarter = scaled(pi(), -1);
  const auto k =
      static_cast<std::int64_t>(std::nearbyint(static_cast<double>(x.middle / quarter.middle)));
  // k times the first part is exact, and so is the first difference: leading digits cancel.
  Wide rest = x.middle;
  for (const double part : kPiParts) rest -= static_cast<Wide>(part) * static_cast<Wide>(k) / 2;
  return turned(small_sine_cosine({rest, x.radius + 0x1p-106}), k);
}

// The argument is k 2^-61 turns; the nearest quarter is taken off exactly.
inline SineCosine sine_cosine_of_turns(const std::uint64_t k) {
  constexpr std::uint64_t quarter = std::uint64_t{1} << 59U;
  const std::uint64_t nearest = (k + quarter / 2) / quarter;
  const auto rest = static_cast<std::int64_t>(k - nearest * quarter);
  const Ball turns{static_cast<Wide>(rest) * static_cast<Wide>(0x1p-60), 0.0};  // 2 * 2^-61
  return turned(small_sine_cosine(turns * pi()), static_cast<std::int64_t>(nearest));
}

struct Vector {
  Ball x, y;
};

inline Vector operator+(const Vector& a, const Vector& b) {
  return {a.x + b.x, a.y + b.y};
}
inline Vector operator-(const Vector& a, const Vector& b) {
  return {a.x - b.x, a.y - b.y};
}
inline Vector operator*(const Ball& s, const Vector& a) {
  return {s * a.x, s * a.y};
}
inline Ball dot(const Vector& a, const Vector& b) {
  return a.x * b.x + a.y * b.y;
}
// a turned by +90 degrees.
inline Vector perpendicular(const Vector& a) {
  return {-a.y, a.x};
}
inline Ball length(const Vector& a) {
  return square_root(dot(a, a));
}
inline Vector rotated(const SineCosine& r, const Vector& a) {
  return {r.cosine * a.x - r.sine * a.y, r.sine * a.x + r.cosine * a.y};
}

}  // namespace exact
