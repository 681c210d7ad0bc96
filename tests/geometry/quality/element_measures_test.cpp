#include "geometry/quality/element_measures.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace af2::geometry {
namespace {

using Corners = std::vector<Point3>;
const double kSixty = std::sqrt(3.0) / 2;  // the sine

TEST(ScaledJacobian, IsOneForIdealElementsOfAnySize) {
  EXPECT_NEAR(scaledJacobian(Corners{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}), 1, 1e-15);
  EXPECT_NEAR(scaledJacobian(Corners{{0, 0, 0}, {0, 7, 0}, {0, 7, 7}, {0, 0, 7}}), 1, 1e-15);
  EXPECT_NEAR(scaledJacobian(Corners{{0, 0, 0}, {1, 0, 0}, {0.5, kSixty, 0}}), 1, 1e-15);
}

TEST(ScaledJacobian, IsOneForRectangles) {
  EXPECT_NEAR(scaledJacobian(Corners{{0, 0, 0}, {5, 0, 0}, {5, 1, 0}, {0, 1, 0}}), 1, 1e-15);
}

TEST(ScaledJacobian, OfAShearedSquareIsTheSineOfItsAngle) {
  EXPECT_NEAR(scaledJacobian(Corners{{0, 0, 0}, {1, 0, 0}, {1.5, kSixty, 0}, {0.5, kSixty, 0}}),
              kSixty, 1e-15);
}

TEST(ScaledJacobian, OfTheRightTriangleWithEqualLegs) {
  // 2 / sqrt 3 times 1 over the product of a leg and the longest side, sqrt 2
  EXPECT_NEAR(scaledJacobian(Corners{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}),
              2 / std::sqrt(3.0) / std::sqrt(2.0), 1e-15);
}

TEST(ScaledJacobian, IsNegativeAtAReflexCorner) {
  EXPECT_LT(scaledJacobian(Corners{{0, 0, 0}, {2, 0, 0}, {0.5, 0.5, 0}, {0, 2, 0}}), 0);
}

TEST(ScaledJacobian, IsZeroForDegenerateElements) {
  EXPECT_EQ(scaledJacobian(Corners{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}), 0);
  EXPECT_EQ(scaledJacobian(Corners{{1, 1, 1}, {1, 1, 1}, {1, 1, 1}, {1, 1, 1}}), 0);
}

TEST(AspectRatio, IsOneForIdealElements) {
  EXPECT_NEAR(aspectRatio(Corners{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}), 1, 1e-15);
  EXPECT_NEAR(aspectRatio(Corners{{0, 0, 0}, {1, 0, 0}, {0.5, kSixty, 0}}), 1, 1e-15);
}

TEST(AspectRatio, OfARectangle) {
  EXPECT_NEAR(aspectRatio(Corners{{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {0, 1, 0}}), 1.5, 1e-15);
}

TEST(AspectRatio, IsInfiniteWithoutArea) {
  EXPECT_TRUE(std::isinf(aspectRatio(Corners{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}})));
}

TEST(CornerAngle, IsAbove180AtAReflexCorner) {
  const Corners dart{{0, 0, 0}, {2, 0, 0}, {0.5, 0.5, 0}, {0, 2, 0}};
  EXPECT_NEAR(cornerAngle(dart, 0), 90, 1e-12);
  EXPECT_GT(cornerAngle(dart, 2), 180);
  EXPECT_NEAR(
      cornerAngle(dart, 0) + cornerAngle(dart, 1) + cornerAngle(dart, 2) + cornerAngle(dart, 3),
      360, 1e-12);
}

}  // namespace
}  // namespace af2::geometry
