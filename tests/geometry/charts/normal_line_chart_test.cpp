#include "geometry/charts/normal_line_chart.h"

#include <gtest/gtest.h>

#include <cmath>

#include "geometry/charts/quadric_surfaces.h"
#include "tests/geometry/charts/charts.h"

namespace af2::geometry {
namespace {

/// A cylinder of radius 1 along the y axis; the base edge runs along it, at the top.
class NormalLines : public ::testing::Test {
 protected:
  NormalLines() : cylinder({0, 0, 0}, {0, 1, 0}, 1, Side::Outer) {}
  SurfacePoint at(double angle, double y) const {
    const Point3 normal{-std::sin(angle), 0, std::cos(angle)};
    return {{normal.x, y, normal.z}, normal};
  }
  NormalLineChart<CylinderSurface> chart() const {
    return {cylinder, at(0, 0), at(0, 0.5), 0.5, ChartLimits{}};
  }
  CylinderSurface cylinder;
};

TEST_F(NormalLines, PutTheBaseEdgeOnTheXAxis) {
  EXPECT_LT(testing::gap(chart().transformFromSurface(at(0, 0)).position, {0, 0}), 1e-15);
  EXPECT_LT(testing::gap(chart().transformFromSurface(at(0, 0.5)).position, {1, 0}), 1e-15);
}

TEST_F(NormalLines, MakeATangentOfAnArc) {
  for (const double angle : {0.1, 0.5, -0.9})
    EXPECT_NEAR(chart().transformFromSurface(at(angle, 0.2)).position.y, 2 * std::tan(angle),
                1e-14);
}

TEST_F(NormalLines, ComeBackToTheNearestPointOfTheSurface) {
  const auto back = chart().transformToSurface({0.4, 2 * 0.3});
  ASSERT_TRUE(back);
  EXPECT_LT(distance(back->position, at(std::atan(0.3), 0.2).position), 1e-4);
  EXPECT_NEAR(length(Point2{back->position.x, back->position.z}), 1, 1e-15);
}

TEST_F(NormalLines, SeeWhatTurnsAwayWithoutMatchingIt) {
  EXPECT_EQ(chart().transformFromSurface(at(1.2, 0)).view, ChartView::Legal);
  EXPECT_EQ(chart().transformFromSurface(at(1.4, 0)).view, ChartView::Obstacle);
  EXPECT_EQ(chart().transformFromSurface(at(2, 0)).view, ChartView::Hidden);
}

}  // namespace
}  // namespace af2::geometry
