// What follows from a motion's other fields, and what is left of it when parts are made flat.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "pdg/native/geometry/motion.hpp"

namespace {

using pdg::Motion;
using pdg::MotionPart;
using pdg::Vec2;

Motion cell() {
  Motion m = pdg::make_motion({0.5, -0.25}, {3.0, 0.0}, {0.0, 4.0}, pdg::half_angle_of(0.3), 7.0);
  m.margin = 0.125;
  m.angle_error = 0.0625;
  return m;
}

TEST(PdgMotion, LengthsAndAnglesFollow) {
  const Motion m = cell();
  EXPECT_EQ(m.g1_length, 3.0);
  EXPECT_EQ(m.g2_length, 4.0);
  EXPECT_EQ(m.half_angle, 0.3);
  EXPECT_EQ(m.cos_half, std::cos(0.3));
  EXPECT_EQ(m.sin_half, std::sin(0.3));
  EXPECT_EQ(m.turn, 0.0);
  EXPECT_EQ(m.reach, 7.0);
}

TEST(PdgMotion, ASegmentTurnsWithItsTranslation) {
  const Motion m = pdg::make_segment_motion({}, {3.0, 4.0}, -0.2, 1.0);
  EXPECT_EQ(m.g1_length, 5.0);
  EXPECT_EQ(m.turn, -0.2);
  EXPECT_EQ(m.half_angle, 0.2);
  EXPECT_EQ(m.sin_half, std::sin(0.2));
}

// Squares of such lengths underflow or overflow.
TEST(PdgMotion, LengthsAlongAxesAreExact) {
  for (const double length : {1e-200, std::numeric_limits<double>::denorm_min(), 1e200, 0.0}) {
    EXPECT_EQ(pdg::generator_length({length, 0.0}), length);
    EXPECT_EQ(pdg::generator_length({0.0, -length}), length);
  }
}

TEST(PdgMotion, FlatPartsAreGoneAndTheRestStays) {
  const Motion m = cell();
  const Motion x = flattened(m, MotionPart::kG1);
  EXPECT_EQ(x.g1, Vec2{});
  EXPECT_EQ(x.g1_length, 0.0);
  EXPECT_EQ(x.g2, m.g2);
  EXPECT_EQ(x.g2_length, m.g2_length);
  EXPECT_EQ(x.sin_half, m.sin_half);
  EXPECT_EQ(flattened(m, MotionPart::kG2).g2_length, 0.0);
  const Motion turn =
      flattened(pdg::make_segment_motion({}, {1.0, 1.0}, 0.2, 1.0), MotionPart::kTurn);
  EXPECT_EQ(turn.half_angle, 0.0);
  EXPECT_EQ(turn.turn, 0.0);
  EXPECT_EQ(turn.cos_half, 1.0);
  EXPECT_EQ(turn.sin_half, 0.0);
  const Motion centre = centre_of(m);
  EXPECT_EQ(centre.t, m.t);
  EXPECT_EQ(box_extent(centre), Vec2{});
  EXPECT_EQ(centre.half_angle, 0.0);
  for (const Motion& left : {x, centre}) {
    EXPECT_EQ(left.reach, m.reach);
    EXPECT_EQ(left.margin, m.margin);
    EXPECT_EQ(left.angle_error, m.angle_error);
  }
}

TEST(PdgMotion, ExtentsHoldTheCorners) {
  const Motion m = pdg::make_motion({}, {1.0, 2.0}, {-3.0, 0.5}, {}, 4.0);
  EXPECT_EQ(box_extent(m), (Vec2{4.0, 2.5}));
  EXPECT_EQ(extent_along(m, {0.0, 1.0}), 2.5);
}

}  // namespace
