#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "integer_oracle.hpp"
#include "pdg/native/geometry/predicates.hpp"

namespace {

using oracle::Wide;
using pdg::Vec2;

int sign(const Wide v) {
  return (v > 0) - (v < 0);
}

// Integers of up to 52 bits: differences fit 64 bits, the determinant 128.
int integer_orientation(const Vec2 a, const Vec2 b, const Vec2 c) {
  const auto i = [](const double v) { return static_cast<Wide>(static_cast<std::int64_t>(v)); };
  return sign((i(a.x) - i(c.x)) * (i(b.y) - i(c.y)) - (i(a.y) - i(c.y)) * (i(b.x) - i(c.x)));
}

TEST(Orient2d, AgreesWithIntegersNearCollinearity) {
  std::mt19937_64 random(1);
  std::uniform_int_distribution<std::int64_t> coordinate(-(1LL << 50), 1LL << 50);
  std::uniform_int_distribution<int> jitter(-1, 1);
  int zeros = 0;
  int wrong_in_doubles = 0;
  for (int k = 0; k < 200000; ++k) {
    const std::int64_t dx = coordinate(random) >> (1 + k % 40);
    const std::int64_t dy = coordinate(random) >> (1 + k % 40);
    const std::int64_t m = k % 3 - 1;
    const Vec2 a{static_cast<double>(coordinate(random)), static_cast<double>(coordinate(random))};
    const Vec2 b{a.x + static_cast<double>(dx), a.y + static_cast<double>(dy)};
    const Vec2 c{a.x + static_cast<double>(m * dx + jitter(random)),
                 a.y + static_cast<double>(m * dy + jitter(random))};
    const int expected = integer_orientation(a, b, c);
    ASSERT_EQ(pdg::orient2d(a, b, c), expected);
    ASSERT_EQ(pdg::orient2d(b, a, c), -expected);
    ASSERT_EQ(pdg::orient2d(b, c, a), expected);
    const double plain = (a.x - c.x) * (b.y - c.y) - (a.y - c.y) * (b.x - c.x);
    zeros += expected == 0;
    wrong_in_doubles += ((plain > 0) - (plain < 0)) != expected;
  }
  EXPECT_GT(zeros, 1000);
  EXPECT_GT(wrong_in_doubles, 10);  // the samples do exercise the exact branch
}

// Powers of two scale every intermediate exactly, to both ends of the admitted range.
TEST(Orient2d, HoldsAtTheEndsOfTheRange) {
  std::mt19937_64 random(2);
  std::uniform_int_distribution<std::int64_t> coordinate(1, (1LL << 50) - 1);
  std::uniform_int_distribution<int> jitter(-1, 1);
  for (int k = 0; k < 20000; ++k) {
    const std::int64_t dx = coordinate(random) >> 3;
    const std::int64_t dy = coordinate(random) >> 3;
    const Vec2 a{static_cast<double>(coordinate(random)), static_cast<double>(coordinate(random))};
    const Vec2 b{a.x + static_cast<double>(dx), a.y + static_cast<double>(dy)};
    const Vec2 c{a.x + static_cast<double>(2 * dx + jitter(random)),
                 a.y + static_cast<double>(2 * dy + jitter(random))};
    const int expected = integer_orientation(a, b, c);
    for (const double scale : {0x1p-485, 0x1p447}) {
      ASSERT_TRUE(pdg::in_exact_range(scale * a) && pdg::in_exact_range(scale * c));
      ASSERT_EQ(pdg::orient2d(scale * a, scale * b, scale * c), expected);
    }
  }
}

TEST(Orient2d, MixesMagnitudes) {
  EXPECT_EQ(pdg::orient2d({0, 0}, {1, 1}, {0x1p400, 0x1p400}), 0);
  EXPECT_EQ(pdg::orient2d({0, 0}, {1, 1}, {0x1p400, std::nextafter(0x1p400, 1e300)}), 1);
  EXPECT_EQ(pdg::orient2d({0x1p-400, 0}, {1, 1}, {2, 2}), -1);
  EXPECT_EQ(pdg::orient2d({0, 0x1p-400}, {1, 1}, {2, 2}), 1);
  EXPECT_EQ(pdg::orient2d({0, 0}, {0x1p-485, 0x1p-485}, {0x1p500, 0x1p500}), 0);
}

TEST(ExactRange, RejectsWhatArithmeticCannotHold) {
  EXPECT_TRUE(pdg::in_exact_range({0.0, -1.0}));
  EXPECT_FALSE(pdg::in_exact_range({0x1p-490, 0.0}));
  EXPECT_FALSE(pdg::in_exact_range({0.0, 0x1p501}));
  EXPECT_FALSE(pdg::in_exact_range({std::nan(""), 0.0}));
  EXPECT_FALSE(pdg::in_exact_range({0.0, -INFINITY}));
}

TEST(TurnsLeftOrStraight, RejectsGoingBack) {
  EXPECT_TRUE(pdg::turns_left_or_straight({0, 0}, {1, 0}, {2, 0}));
  EXPECT_FALSE(pdg::turns_left_or_straight({0, 0}, {1, 0}, {0.5, 0}));
  EXPECT_TRUE(pdg::turns_left_or_straight({0, 0}, {1, 0}, {0.5, 1}));
  EXPECT_FALSE(pdg::turns_left_or_straight({0, 0}, {1, 0}, {2, -1}));
}

}  // namespace
