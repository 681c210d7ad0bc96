#include "geometry/metric_chart.h"

#include <gtest/gtest.h>

#include "engine/error.h"
#include "tests/geometry/charts.h"

namespace af2::geometry {
namespace {

/// A cylinder of radius 2 by angle and height.
class Cylinder final : public ParametricSurface {
 public:
  explicit Cylinder(bool flipped) : flipped_(flipped) {}
  Frame frameAt(double u, double v) const override {
    return {
        {2 * std::cos(u), 2 * std::sin(u), v}, {-2 * std::sin(u), 2 * std::cos(u), 0}, {0, 0, 1}};
  }
  SurfacePoint pointAt(double u, double v) const override {
    const Point3 outer{std::cos(u), std::sin(u), 0};
    return {frameAt(u, v).position, (flipped_ ? -1.0 : 1.0) * outer, u, v};
  }
  bool isFlipped() const override { return flipped_; }

 private:
  bool flipped_;
};

TEST(MetricChart, UnrollsACylinder) {
  const Cylinder cylinder(false);
  const SurfacePoint from = cylinder.pointAt(0, 0), to = cylinder.pointAt(0, 1);
  const auto chart = MetricChartMaker(cylinder).makeLocalTransform(from, to, 1);
  EXPECT_LT(testing::gap(chart->transformFromSurface(to).position, {1, 0}), 1e-14);
  // Seen from outside, the left of "up" is against the sense of the angle; half a turn is 2 pi
  // long.
  const SurfacePoint behind = cylinder.pointAt(-3, 0.5);
  EXPECT_LT(testing::gap(chart->transformFromSurface(behind).position, {0.5, 6}), 1e-13);
  const auto back = chart->transformToSurface({0.5, 6});
  ASSERT_TRUE(back);
  EXPECT_LT(testing::gap(back->position, behind.position), 1e-13);
}

TEST(MetricChart, IsMirroredWhereTheFaceIsSeenFromTheOtherSide) {
  const Cylinder cylinder(true);
  const auto chart = MetricChartMaker(cylinder).makeLocalTransform(cylinder.pointAt(0, 0),
                                                                   cylinder.pointAt(0, 1), 1);
  EXPECT_LT(testing::gap(chart->transformFromSurface(cylinder.pointAt(1, 0)).position, {0, 2}),
            1e-14);
}

TEST(MetricChart, PutsTheEndOfTheBaseEdgeAtItsChord) {
  const Cylinder cylinder(false);
  const SurfacePoint from = cylinder.pointAt(0, 0), to = cylinder.pointAt(1, 0.3);
  const auto chart = MetricChartMaker(cylinder).makeLocalTransform(from, to, 0.5);
  const double chord = distance(from.position, to.position);
  EXPECT_LT(testing::gap(chart->transformFromSurface(to).position, {chord / 0.5, 0}), 1e-13);
}

}  // namespace
}  // namespace af2::geometry
