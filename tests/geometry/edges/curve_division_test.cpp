#include "geometry/edges/curve_division.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace af2::geometry {
namespace {

TEST(CurveDivision, MakesTheNearestNumberOfSegments) {
  EXPECT_EQ(wholeSegments(0.1, 0), 1u);
  EXPECT_EQ(wholeSegments(3.4, 0), 3u);
  EXPECT_EQ(wholeSegments(3.6, 0), 4u);
}

TEST(CurveDivision, MakesNoSegmentLongerThanWantedWhereACurveTurns) {
  EXPECT_EQ(wholeSegments(3.1, 3.1), 4u);
  EXPECT_EQ(wholeSegments(3.1, 1), 4u) << "turns by a third of what a segment may";
  EXPECT_EQ(wholeSegments(3.1, 0.5), 3u) << "all but straight";
  EXPECT_EQ(wholeSegments(3.005, 3.005), 3u) << "but for rounding";
  EXPECT_EQ(wholeSegments(3.1, 2.8, 0.9), 3u) << "counted in nine tenths of the wanted size";
}

TEST(CurveDivision, AllowsFewerSegmentsOnlyWhereACurveHardlyTurns) {
  EXPECT_EQ(fewestSegments(3.6, 0), 1u);
  EXPECT_EQ(fewestSegments(3.6, 0.5), 1u);
  EXPECT_EQ(fewestSegments(3.6, 3.6), 4u);
  EXPECT_EQ(fewestSegments(0.3, 0.3), 1u);
}

TEST(CurveDivision, AddsUpHowACurveTurns) {
  std::vector<Point3> arc;
  for (int i = 0; i <= 100; ++i) {
    const double angle = std::numbers::pi / 2 * i / 100;
    arc.push_back({std::cos(angle), std::sin(angle), 3});
  }
  EXPECT_NEAR(turnAlong(arc), std::numbers::pi / 2, 1e-4);
  EXPECT_EQ(turnAlong(std::vector<Point3>{{0, 0, 0}, {1, 0, 0}}), 0);
}

}  // namespace
}  // namespace af2::geometry
