#include "engine/surface/plane_chart.h"

#include <gtest/gtest.h>

#include "tests/geometry/charts/charts.h"

namespace af2 {
namespace {

TEST(PlaneChart, IsExactThereAndBack) {
  const Point3 normal = unit(Point3{1, 2, 2});
  const Point3 along = unit(Point3{2, -1, 0});
  const testing::BaseEdge base({5, 6, 7}, 3 * along, normal);
  const auto chart = PlaneChartMaker(normal).makeLocalTransform(base.from, base.to, 2);
  EXPECT_LT(testing::gap(chart->transformFromSurface(base.to).position, {1.5, 0}), 1e-14);
  const auto lifted = chart->transformToSurface({0.3, 0.7});
  ASSERT_TRUE(lifted);
  EXPECT_LT(testing::gap(chart->transformFromSurface(*lifted).position, {0.3, 0.7}), 1e-14);
  EXPECT_NEAR(dot(lifted->position - base.from.position, normal), 0, 1e-14);
}

TEST(PlaneChart, HasTheRegionToTheLeftAbove) {
  const testing::BaseEdge base({0, 0, 0}, {1, 0, 0}, {0, 0, -1});
  const auto chart = PlaneChartMaker({0, 0, -1}).makeLocalTransform(base.from, base.to, 1);
  EXPECT_LT(testing::gap(chart->transformToSurface({0, 1})->position, {0, -1, 0}), 1e-15);
}

}  // namespace
}  // namespace af2
