#include "geometry/charts/mean_normal_chart.h"

#include <gtest/gtest.h>

#include "engine/base/error.h"
#include "geometry/charts/quadric_surfaces.h"
#include "tests/geometry/charts/charts.h"

namespace af2::geometry {
namespace {

using testing::BaseEdge;
using testing::gap;

const double kHalf = std::sqrt(0.5);

/// Numbers on the torus with radii 3 and 1 around the z axis are facts taken from the test suite of
/// MeshKit's plane projection.
class TorusChart : public ::testing::Test {
 protected:
  TorusSurface torus{{0, 0, 0}, {0, 0, 1}, 3, 1, Side::Outer};
  MeanNormalChartMaker<TorusSurface> charts{torus};
};

TEST_F(TorusChart, ProjectsOrthogonallyOntoItsPlane) {
  const BaseEdge base({2.8, 2.8, 0}, {-kHalf, kHalf, 0}, {kHalf, kHalf, 0});
  const auto chart = charts.makeLocalTransform(base.from, base.to, 1);
  const Point3 position{2.8059735404411, 2.8059735404411, 0.25};
  const ChartPoint point = chart->transformFromSurface({position, torus.normalAt(position)});
  EXPECT_LT(gap(point.position, {0, 0.25}), 1e-12);
  EXPECT_EQ(point.view, ChartView::Legal);
}

TEST_F(TorusChart, GoesBackAlongItsNormal) {
  const BaseEdge base({2.8, 2.8, 0}, {-kHalf, kHalf, 0}, {kHalf, kHalf, 0});
  const auto chart = charts.makeLocalTransform(base.from, base.to, 1);
  const auto point = chart->transformToSurface({0, 0.574682269122808});
  ASSERT_TRUE(point);
  EXPECT_LT(gap(point->position, {2.7, 2.7, 0.574682269122808}), 1e-12);
}

TEST_F(TorusChart, GoesBackAlongAnObliqueNormal) {
  const BaseEdge base({2.6, 0, 0}, {kHalf, 0, kHalf}, {-kHalf, 0, kHalf});
  const auto chart = charts.makeLocalTransform(base.from, base.to, 1);
  const auto point = chart->transformToSurface({1.1726465796702328, 0.1});
  ASSERT_TRUE(point);
  EXPECT_LT(gap(point->position, {3.3072251285719, 0.1, 0.9511475682682}), 1e-12);
}

TEST_F(TorusChart, HidesTheOtherSideOfTheTube) {
  const BaseEdge base({4, 0, 0}, {0, 0.1, 0}, {1, 0, 0});
  const auto chart = charts.makeLocalTransform(base.from, base.to, 0.1);
  EXPECT_EQ(chart->transformFromSurface({{2, 0, 0}, {-1, 0, 0}}).view, ChartView::Hidden);
}

TEST(MeanNormalChart, PutsTheBaseEdgeOnTheXAxisInUnitsOfTheWantedLength) {
  const SphereSurface sphere({1, 2, 3}, 2, Side::Outer);
  const MeanNormalChartMaker<SphereSurface> charts(sphere);
  const Point3 p{3, 2, 3}, q = Point3{1, 2, 3} + 2 * unit(Point3{1, 0.2, -0.1});
  const SurfacePoint from{p, sphere.normalAt(p)}, to{q, sphere.normalAt(q)};
  const auto chart = charts.makeLocalTransform(from, to, 0.5);
  EXPECT_EQ(chart->transformFromSurface(from).position, (Point2{0, 0}));
  EXPECT_LT(gap(chart->transformFromSurface(to).position, {distance(p, q) / 0.5, 0}), 1e-14);
}

TEST(MeanNormalChart, HasTheRegionToTheLeftOnThePositiveYSide) {
  const SphereSurface sphere({0, 0, 0}, 1, Side::Inner);
  const MeanNormalChartMaker<SphereSurface> charts(sphere);
  const SurfacePoint from{{0, 0, 1}, {0, 0, -1}}, to{{0.1, 0, std::sqrt(0.99)}, {0, 0, -1}};
  const auto chart = charts.makeLocalTransform(from, to, 0.1);
  // Seen from below, where the inner normals point to, the left of +x is -y.
  EXPECT_GT(chart->transformFromSurface({{0, -0.1, 1}, {0, 0, -1}}).position.y, 0.9);
}

TEST(MeanNormalChart, RefusesABaseEdgeWhoseNormalsCancel) {
  const CylinderSurface cylinder({0, 0, 0}, {0, 0, 1}, 1, Side::Outer);
  const MeanNormalChartMaker<CylinderSurface> charts(cylinder);
  const SurfacePoint from{{1, 0, 0}, {1, 0, 0}}, to{{-1, 0, 0}, {-1, 0, 0}};
  EXPECT_THROW(charts.makeLocalTransform(from, to, 1), GeometryError);
}

TEST(MeanNormalChart, DoesNotReachBeyondTheLimbOfACylinder) {
  const CylinderSurface cylinder({0, 0, 0}, {0, 0, 1}, 1, Side::Outer);
  const MeanNormalChartMaker<CylinderSurface> charts(cylinder);
  const SurfacePoint from{{1, 0, 0}, {1, 0, 0}}, to{{1, 0, 0.5}, {1, 0, 0}};
  const auto chart = charts.makeLocalTransform(from, to, 1);
  EXPECT_TRUE(chart->transformToSurface({0.5, 0.9}));
  EXPECT_FALSE(chart->transformToSurface({0.5, 0.99}));  // too steep
  EXPECT_FALSE(chart->transformToSurface({0.5, 1.01}));  // past it
}

TEST(MeanNormalChart, IsTheSameInASlotAndOnTheHeap) {
  const SphereSurface sphere({0, 0, 0}, 1, Side::Outer);
  const MeanNormalChartMaker<SphereSurface> charts(sphere);
  const SurfacePoint from{{1, 0, 0}, {1, 0, 0}}, to{{0, 1, 0}, {0, 1, 0}};
  ChartSlot slot;
  const AF2LocalTransform& inSlot = charts.makeLocalTransformIn(slot, from, to, 0.3);
  const auto onHeap = charts.makeLocalTransform(from, to, 0.3);
  EXPECT_EQ(inSlot.transformToSurface({1, 1}), onHeap->transformToSurface({1, 1}));
}

}  // namespace
}  // namespace af2::geometry
