#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "pdg/native/geometry/predicates.hpp"
#include "pdg/native/pieces/validity.hpp"

namespace {

using pdg::Polygon;
using pdg::Ring;
using pdg::Vec2;

std::string defect(const Polygon& polygon) {
  const auto found = pdg::find_defect(polygon);
  return found ? found->what : "";
}

const Ring kSquare = {{0, 0}, {8, 0}, {8, 8}, {0, 8}};

TEST(Validity, SimplePolygonsHaveNone) {
  EXPECT_EQ(defect({{kSquare}}), "");
  EXPECT_EQ(defect({{{{0, 0}, {0, 8}, {3, 5}, {8, 8}, {8, 0}}}}), "");  // clockwise, not convex
  EXPECT_EQ(defect({{{{0, 0}, {4, 0}, {8, 0}, {8, 8}, {4, 3}, {0, 8}}}}), "");  // straight angle
  EXPECT_EQ(defect({{kSquare, {{1, 1}, {2, 1}, {2, 2}}, {{4, 4}, {4, 6}, {6, 6}}}}), "");
}

TEST(Validity, HolesMayTouchInSinglePoints) {
  EXPECT_EQ(defect({{kSquare, {{0, 4}, {4, 3}, {4, 5}}}}), "");  // inside an edge
  EXPECT_EQ(defect({{kSquare, {{0, 0}, {4, 3}, {3, 4}}}}), "");  // at a vertex
  EXPECT_EQ(defect({{kSquare, {{1, 1}, {4, 1}, {4, 4}}, {{4, 4}, {6, 4}, {6, 6}}}}), "");
}

TEST(Validity, RingsThatMeetThemselves) {
  const auto found = pdg::find_defect({{{{4, 4}, {6, 6}, {6, 4}, {4, 6}}}});
  ASSERT_TRUE(found);
  EXPECT_STREQ(found->what, "self-intersection");
  EXPECT_EQ(found->where, (Vec2{5, 5}));
  EXPECT_EQ(defect({{{{0, 0}, {8, 0}, {4, 4}, {8, 8}, {0, 8}, {4, 4}}}}),
            "ring self-intersection");  // twice through a vertex
  EXPECT_EQ(defect({{{{0, 0}, {8, 0}, {8, 8}, {4, 0}, {0, 8}}}}),
            "ring self-intersection");  // a vertex on an edge
  EXPECT_NE(defect({{{{0, 0}, {8, 0}, {8, 4}, {9, 4}, {8, 4.5}, {8, 4.25}, {8, 8}, {0, 8}}}}),
            "");  // back along itself
}

TEST(Validity, RingsThatMeetEachOther) {
  EXPECT_EQ(defect({{kSquare, {{4, 4}, {12, 4}, {12, 5}}}}), "self-intersection");
  EXPECT_EQ(defect({{kSquare, {{0, 2}, {4, 3}, {0, 6}}}}), "self-intersection");  // along an edge
  EXPECT_EQ(defect({{kSquare, kSquare}}), "self-intersection");
  EXPECT_EQ(defect({{kSquare, {{9, 1}, {10, 1}, {10, 2}}}}), "hole lies outside shell");
  EXPECT_EQ(defect({{kSquare, {{8, 4}, {10, 1}, {10, 6}}}}), "hole lies outside shell");
  EXPECT_EQ(defect({{kSquare, {{-1, -1}, {9, -1}, {9, 9}, {-1, 9}}}}), "hole lies outside shell");
  EXPECT_EQ(defect({{kSquare, {{1, 1}, {7, 1}, {7, 7}}, {{4, 2}, {6, 2}, {6, 4}}}}),
            "holes are nested");
}

TEST(Validity, InteriorsInParts) {
  EXPECT_EQ(defect({{kSquare, {{0, 4}, {4, 3}, {8, 4}, {4, 5}}}}), "interior is disconnected");
  EXPECT_EQ(defect({{kSquare, {{0, 4}, {4, 3}, {4, 5}}, {{4, 3}, {8, 4}, {4, 1}}}}),
            "interior is disconnected");
}

// Shapely (GEOS, in doubled doubles) finds both of these valid.
TEST(Validity, DecidedExactly) {
  const Ring shell = {{-0.5, 0.5000000000000001}, {3.0, 4.0}, {-3.0, -1.0}, {-4.0, -3.0}};
  const Ring crossing = {{-3.9999999999999996, -2.9999999999999996},
                         {0.39426472231394527, 1.3942647223139455},
                         {-0.554995261881771, 0.44500473811822927}};
  EXPECT_EQ(defect({{shell, crossing}}), "self-intersection");
  const Ring far = {{-1.0, -100000.0},
                    {-0.3141794525867426, -685820578831.2025},
                    {-0.9999999999999997, -100000.00000000001},
                    {1.0, 1.0},
                    {-1e-20, -1e-50},
                    {-8388608.0, 1e-20},
                    {-8388607.999999999, 0.0},
                    {-1e-20, -1000000000000.0}};
  const Ring outside = {{-1e-20, -1e-50}, {1e-50, 1e-20}, {-0.1, 0.1}};
  EXPECT_EQ(defect({{far, outside}}), "hole lies outside shell");
}

// One unit in the last place decides.
TEST(Validity, NeighbouringDoubles) {
  const double apex = 1.0 / 3.0;
  const auto notched = [](const double y) {
    return Polygon{
        {{{0, 0}, {1, 0}, {1, 1}, {0.5, y}, {0, 1}}, {{0.4, 0.1}, {0.6, 0.1}, {0.5, 1.0 / 3.0}}}};
  };
  EXPECT_EQ(defect(notched(apex)), "");  // they touch
  EXPECT_EQ(defect(notched(std::nextafter(apex, 1.0))), "");
  EXPECT_EQ(defect(notched(std::nextafter(apex, 0.0))), "self-intersection");
}

}  // namespace
