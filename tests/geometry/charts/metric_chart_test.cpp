#include "geometry/charts/metric_chart.h"

#include <gtest/gtest.h>

#include "engine/base/error.h"
#include "tests/geometry/charts/charts.h"

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
  bool has(double, double v) const override { return v >= 0 && v <= 1; }

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

TEST(MetricChart, DoesNotReachBeyondTheSurface) {
  const Cylinder cylinder(false);
  const auto chart = MetricChartMaker(cylinder).makeLocalTransform(cylinder.pointAt(0, 0),
                                                                   cylinder.pointAt(0, 1), 1);
  EXPECT_TRUE(chart->transformToSurface({0.9, 1}));
  EXPECT_FALSE(chart->transformToSurface({1.1, 1}));
}

TEST(MetricChart, PutsTheEndOfTheBaseEdgeAtItsChord) {
  const Cylinder cylinder(false);
  const SurfacePoint from = cylinder.pointAt(0, 0), to = cylinder.pointAt(1, 0.3);
  const auto chart = MetricChartMaker(cylinder).makeLocalTransform(from, to, 0.5);
  const double chord = distance(from.position, to.position);
  EXPECT_LT(testing::gap(chart->transformFromSurface(to).position, {chord / 0.5, 0}), 1e-13);
}

/// A cone with its tip at the origin, by angle and distance from the tip: not lengths.
class Cone final : public ParametricSurface {
 public:
  Frame frameAt(double u, double v) const override {
    return {v * ruling(u), (kSine * v) * Point3{-std::sin(u), std::cos(u), 0}, ruling(u)};
  }
  SurfaceJet jetAt(double u, double v) const override {
    const Frame f = frameAt(u, v);
    return {f.position,
            f.du,
            f.dv,
            (kSine * v) * Point3{-std::cos(u), -std::sin(u), 0},
            kSine * Point3{-std::sin(u), std::cos(u), 0},
            {}};
  }
  SurfacePoint pointAt(double u, double v) const override {
    const Frame f = frameAt(u, v);
    return {f.position, unit(cross(f.du, f.dv)), u, v};
  }
  bool isFlipped() const override { return false; }
  /// Unrolled.
  static Point2 flat(const SurfacePoint& p) {
    return {p.v * std::cos(kSine * p.u), p.v * std::sin(kSine * p.u)};
  }

 private:
  static constexpr double kSine = 0.6;
  static Point3 ruling(double u) { return {kSine * std::cos(u), kSine * std::sin(u), 0.8}; }
};

/// Distances on the cone are those of the unrolled one. Near the base edge the chart keeps them to
/// second order, which charts that are affine in the parameters do not.
TEST(MetricChart, KeepsLengthsToSecondOrder) {
  const Cone cone;
  for (const double step : {0.2, 0.1, 0.05}) {
    const SurfacePoint from = cone.pointAt(0, 2), to = cone.pointAt(step / 1.2, 2);
    const auto chart = MetricChartMaker(cone).makeLocalTransform(from, to, step);
    for (const Point2 off : {Point2{0.5, 1.5}, Point2{-1, -1}, Point2{2, 0.7}}) {
      const SurfacePoint there = cone.pointAt(off.x * step / 1.2, 2 + off.y * step);
      const double drawn = length(chart->transformFromSurface(there).position);
      const double onCone = distance(Cone::flat(from), Cone::flat(there)) / step;
      EXPECT_NEAR(drawn, onCone, 2 * step * step);
    }
  }
}

/// So that what does not cross in one chart crosses in none.
TEST(MetricChart, OfFirstOrderKeepsStraightLinesOfTheParameters) {
  const Cone cone;
  const auto chart = MetricChartMaker(cone, MetricOrder::First)
                         .makeLocalTransform(cone.pointAt(0, 2), cone.pointAt(0.3, 2.1), 0.4);
  const auto at = [&](double u, double v) {
    return chart->transformFromSurface(cone.pointAt(u, v)).position;
  };
  const Point2 ends = at(-1, 0.5) + at(2, 3.5), middle = at(0.5, 2);
  EXPECT_LT(testing::gap(0.5 * ends, middle), 1e-13);
}

TEST(MetricChart, BringsBackWhatItDraws) {
  const Cone cone;
  const auto chart =
      MetricChartMaker(cone).makeLocalTransform(cone.pointAt(0, 2), cone.pointAt(0.3, 2.1), 0.4);
  for (const Point2 place : {Point2{0.5, 0.9}, Point2{-1, 0.5}, Point2{1.5, 1.5}}) {
    const auto point = chart->transformToSurface(place);
    ASSERT_TRUE(point);
    EXPECT_LT(testing::gap(chart->transformFromSurface(*point).position, place), 1e-4);
  }
}

}  // namespace
}  // namespace af2::geometry
