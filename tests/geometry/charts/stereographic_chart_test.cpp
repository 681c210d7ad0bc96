#include "geometry/charts/stereographic_chart.h"

#include <gtest/gtest.h>

#include <cmath>

#include "engine/base/error.h"
#include "engine/step/neighborhood.h"
#include "tests/geometry/charts/charts.h"

namespace af2::geometry {
namespace {

constexpr double kRadius = 2;
const Point3 kCentre{1, -1, 3};

SurfacePoint at(const SphereSurface& sphere, const Point3& direction) {
  const Point3 position = kCentre + kRadius * unit(direction);
  return {position, sphere.normalAt(position)};
}

class StereographicSides : public ::testing::TestWithParam<Side> {
 protected:
  StereographicSides()
      : sphere(kCentre, kRadius, GetParam()),
        from(at(sphere, {1, 0.1, 0.2})),
        to(at(sphere, {1, 0.3, 0.1})),
        chart(sphere, from, to, 0.4) {}
  SphereSurface sphere;
  SurfacePoint from, to;
  StereographicChart chart;
};

TEST_P(StereographicSides, PutsTheBaseEdgeOnTheXAxis) {
  const double size = distance(from.position, to.position) / 0.4;
  EXPECT_LT(testing::gap(chart.transformFromSurface(from).position, {0, 0}), 1e-15);
  EXPECT_LT(testing::gap(chart.transformFromSurface(to).position, {size, 0}), 1e-14);
  // Left of the base edge, seen from the side of the normals.
  const Point3 left = cross(from.normal, to.position - from.position);
  const SurfacePoint beside =
      at(sphere, 0.5 * (from.position + to.position) + 0.1 * left - kCentre);
  EXPECT_GT(chart.transformFromSurface(beside).position.y, 0);
}

TEST_P(StereographicSides, GoesThereAndBackAnywhereOnTheSphere) {
  for (const Point2 place : {Point2{0, 0}, Point2{0.3, 0.9}, Point2{-4, 2}, Point2{20, -35}}) {
    const auto point = chart.transformToSurface(place);
    ASSERT_TRUE(point);
    EXPECT_NEAR(distance(point->position, kCentre), kRadius, 1e-15 * 8);
    EXPECT_LT(distance(point->normal, sphere.normalAt(point->position)), 1e-15 * 4);
    const ChartPoint back = chart.transformFromSurface(*point);
    EXPECT_EQ(back.view, ChartView::Legal);
    EXPECT_LT(testing::gap(back.position, place), 1e-12 * (1 + length(place)));
  }
}

TEST_P(StereographicSides, KeepsAngles) {
  constexpr double kStep = 1e-5;
  for (const Point2 place : {Point2{0.4, 0.8}, Point2{-3, 2}}) {
    const auto pointAt = [&](Point2 p) { return chart.transformToSurface(p)->position; };
    const Point3 x = pointAt(place + Point2{kStep, 0}) - pointAt(place - Point2{kStep, 0});
    const Point3 y = pointAt(place + Point2{0, kStep}) - pointAt(place - Point2{0, kStep});
    EXPECT_NEAR(dot(x, y) / dot(x, x), 0, 1e-7);
    EXPECT_NEAR(dot(y, y) / dot(x, x), 1, 1e-7);
    EXPECT_GT(dot(cross(x, y), chart.transformToSurface(place)->normal), 0);
  }
}

/// What a window shows lies in its box: else the front would not be seen.
TEST_P(StereographicSides, TheBoxOfAWindowHoldsWhatItShows) {
  const StepChart step(chart, 0.4);
  const Window window{-2.5, -0.4, 3, 4};
  const Box3 box = step.boxOf(window, from.position);
  for (int i = 0; i <= 40; ++i)
    for (int j = 0; j <= 40; ++j) {
      const Point2 place{window.lowX + (window.highX - window.lowX) * i / 40,
                         window.lowY + (window.highY - window.lowY) * j / 40};
      const Point3 p = chart.transformToSurface(place)->position;
      EXPECT_TRUE(p.x >= box.low.x - 1e-12 && p.x <= box.high.x + 1e-12 &&
                  p.y >= box.low.y - 1e-12 && p.y <= box.high.y + 1e-12 &&
                  p.z >= box.low.z - 1e-12 && p.z <= box.high.z + 1e-12)
          << place.x << " " << place.y;
    }
}

INSTANTIATE_TEST_SUITE_P(BothSides, StereographicSides, ::testing::Values(Side::Outer, Side::Inner),
                         [](const auto& tested) {
                           return tested.param == Side::Outer ? "Outer" : "Inner";
                         });

TEST(StereographicChart, RefusesOppositePoints) {
  const SphereSurface sphere(kCentre, kRadius, Side::Outer);
  EXPECT_THROW(StereographicChart(sphere, at(sphere, {1, 0, 0}), at(sphere, {-1, 0, 0}), 0.4),
               GeometryError);
}

}  // namespace
}  // namespace af2::geometry
