#include "geometry/base/turns.h"

#include <gtest/gtest.h>

namespace af2::geometry {
namespace {

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
