#include "geometry/base/turns.h"

#include <gtest/gtest.h>

#include <cmath>

namespace af2::geometry {
namespace {

TEST(Turns, DirectionsAgreeWithTheLibrary) {
  for (int i = -4000; i <= 4000; ++i) {
    const double angle = 0.01237 * i;
    const Point2 direction = directionAt(angle);
    EXPECT_NEAR(direction.x, std::cos(angle), 4e-16) << angle;
    EXPECT_NEAR(direction.y, std::sin(angle), 4e-16) << angle;
  }
  EXPECT_NEAR(directionAt(1e5).x, std::cos(1e5), 1e-14);
}

TEST(Turns, AnglesAgreeWithTheLibrary) {
  for (int i = 0; i < 5000; ++i) {
    const double angle = -kPi + 2 * kPi * i / 5000;
    const Point2 p{3.7 * std::cos(angle), 3.7 * std::sin(angle)};
    EXPECT_NEAR(angleOf(p), std::atan2(p.y, p.x), 9e-16) << angle;
  }
}

TEST(Turns, AnglesOfTheAxesAreExact) {
  EXPECT_EQ(angleOf({2, 0}), 0);
  EXPECT_EQ(angleOf({0, 2}), kPi / 2);
  EXPECT_EQ(angleOf({-2, 0}), kPi);
  EXPECT_EQ(angleOf({0, -2}), -kPi / 2);
  EXPECT_EQ(angleOf({0, 0}), 0);
}

TEST(TurnsTowards, BringAnAngleNearestToAnother) {
  EXPECT_EQ(turnsTowards(0.5, 0.5), 0);
  EXPECT_EQ(turnsTowards(0.5, 0.5 + 2 * kPi), 1);
  EXPECT_EQ(turnsTowards(3, -3), -1);
  EXPECT_EQ(turnsTowards(0, 3), 0);
}

TEST(IntoPeriod, TakesWholePeriodsAway) {
  EXPECT_EQ(intoPeriod(0.25, 0, 1), 0.25);
  EXPECT_EQ(intoPeriod(2.25, 0, 1), 0.25);
  EXPECT_EQ(intoPeriod(-0.75, 0, 1), 0.25);
  EXPECT_EQ(intoPeriod(5, 2, 2), 3);
}

}  // namespace
}  // namespace af2::geometry
