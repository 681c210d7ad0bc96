#include "geometry/check/triangle_pair.h"

#include <gtest/gtest.h>

#include <cmath>

namespace af2::geometry {
namespace {

const Corners kFlat{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}};

TEST(ReachIntoEachOther, HoldsWhereAnEdgePierces) {
  EXPECT_TRUE(reachIntoEachOther(kFlat, {{{0.2, 0.2, -1}, {0.2, 0.2, 1}, {0.2, 2, 0}}}, 1e-9));
}

TEST(ReachIntoEachOther, DoesNotHoldForACornerThatTouches) {
  EXPECT_FALSE(reachIntoEachOther(kFlat, {{{0.2, 0.2, 0}, {0.2, 0.2, 1}, {0.2, 2, 1}}}, 1e-9));
}

TEST(ReachIntoEachOther, TakesNoNoticeOfWhatIsLessThanTheDepth) {
  const Corners other{{{0.2, 0.2, -1e-4}, {0.2, 0.2, 1}, {0.2, 2, 1}}};
  EXPECT_TRUE(reachIntoEachOther(kFlat, other, 1e-5));
  EXPECT_FALSE(reachIntoEachOther(kFlat, other, 1e-3));
}

TEST(ReachIntoEachOther, HoldsForTrianglesThatOverlapInOnePlane) {
  EXPECT_TRUE(reachIntoEachOther(kFlat, {{{0.1, 0.1, 0}, {2, 0.1, 0}, {0.1, 2, 0}}}, 1e-9));
  EXPECT_TRUE(reachIntoEachOther(kFlat, kFlat, 1e-9));
  EXPECT_FALSE(reachIntoEachOther(kFlat, {{{1, 0, 0}, {1, 1, 0}, {0, 1, 0}}}, 1e-9));
}

/// Which no face of either separates, but a direction across one edge of each.
TEST(ReachIntoEachOther, SeesThatTwoEdgesPassEachOther) {
  const Corners one{{{-1, 0, 0}, {1, 0, 0}, {0, 0, -1}}};
  const Corners above{{{0, -1, 0.1}, {0, 1, 0.1}, {0, 0, 1}}};
  const Corners across{{{0, -1, -0.1}, {0, 1, -0.1}, {0, 0, 1}}};
  EXPECT_FALSE(reachIntoEachOther(one, above, 1e-9));
  EXPECT_TRUE(reachIntoEachOther(one, across, 1e-9));
}

TEST(AreFolded, HoldsBelowTheAngle) {
  const Point3 a{0, 0, 0}, b{1, 0, 0}, c{0.5, 1, 0};
  const auto leaf = [](double angle) { return Point3{0.4, std::cos(angle), std::sin(angle)}; };
  EXPECT_TRUE(areFolded(a, b, c, leaf(0.001), 0.01));
  EXPECT_FALSE(areFolded(a, b, c, leaf(0.02), 0.01));
  EXPECT_FALSE(areFolded(a, b, c, leaf(3.14159), 0.01));
}

}  // namespace
}  // namespace af2::geometry
