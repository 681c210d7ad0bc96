#include "geometry/charts/conformal_chart.h"

#include <gtest/gtest.h>

#include <cmath>

#include "engine/step/neighborhood.h"
#include "geometry/charts/laid_out.h"
#include "geometry/charts/torus_map.h"
#include "tests/geometry/charts/charts.h"

namespace af2::geometry {
namespace {

using testing::kFrame;
using testing::kLeftHanded;

TorusSurface torusOf(const AxisFrame& frame, Side side) {
  return {frame.origin, frame.axis, 3, 1, side};
}

TEST(TorusMap, KeepsAnglesAndTellsLengths) {
  constexpr double kStep = 1e-5;
  for (const Side side : {Side::Outer, Side::Inner})
    for (const AxisFrame& frame : {kFrame, kLeftHanded}) {
      const TorusMap map(frame, torusOf(frame, side));
      for (const Point2 place : {Point2{0, 0}, Point2{4, 1}, Point2{-7, 3.2}, Point2{30, -9}}) {
        const auto at = [&](double x, double y) { return map.lift(place + Point2{x, y}).position; };
        const Point3 x = (0.5 / kStep) * (at(kStep, 0) - at(-kStep, 0));
        const Point3 y = (0.5 / kStep) * (at(0, kStep) - at(0, -kStep));
        EXPECT_NEAR(length(x) * map.scaleAt(place), 1, 1e-8);
        EXPECT_NEAR(length(y) * map.scaleAt(place), 1, 1e-8);
        EXPECT_NEAR(dot(x, y), 0, 1e-8);
        EXPECT_GT(dot(cross(x, y), map.lift(place).normal), 0);
        const double change = (std::log(map.scaleAt(place + Point2{0, kStep})) -
                               std::log(map.scaleAt(place - Point2{0, kStep}))) /
                              (2 * kStep);
        EXPECT_NEAR(map.scaleGradientAt(place).y, change, 1e-8);
        EXPECT_EQ(map.scaleGradientAt(place).x, 0);
      }
    }
}

TEST(TorusMap, GivesBackPlacesOnAllTurns) {
  const TorusSurface torus = torusOf(kFrame, Side::Outer);
  const TorusMap map(kFrame, torus);
  for (const Point2 place : {Point2{0, 0}, Point2{4, 1}, Point2{-7, 3.2}, Point2{30, -19}}) {
    const SurfacePoint point = map.lift(place);
    EXPECT_NEAR(testing::gap(map.flatten(point), place), 0, 1e-12);
    EXPECT_LT(distance(point.normal, torus.normalAt(point.position)), 1e-14);
  }
}

class ConformalCharts : public ::testing::Test {
 protected:
  ConformalCharts()
      : map(kFrame, torusOf(kFrame, Side::Outer)),
        from(pointInPlane({2, 1.1})),
        to(pointInPlane({2.2, 1.3})),
        chart(map, from, to, 0.3) {}
  TorusMap map;
  SurfacePoint from, to;
  ConformalChart chart;
};

TEST_F(ConformalCharts, PutTheBaseEdgeOnTheXAxis) {
  EXPECT_LT(testing::gap(chart.transformFromSurface(from).position, {0, 0}), 1e-15);
  const Point2 end{distance(from.position, to.position) / 0.3, 0};
  EXPECT_LT(testing::gap(chart.transformFromSurface(to).position, end), 1e-14);
}

TEST_F(ConformalCharts, GoThereAndBack) {
  for (const Point2 place : {Point2{0, 0}, Point2{0.5, 0.9}, Point2{-2, 1.5}, Point2{2, 3}}) {
    const auto point = chart.transformToSurface(place);
    ASSERT_TRUE(point);
    EXPECT_LT(testing::gap(chart.transformFromSurface(*point).position, place), 1e-12);
  }
}

/// The plane alone has lengths that are right at the base edge only.
TEST_F(ConformalCharts, TellLengthsOnTheSurfaceToFirstOrder) {
  const auto lengthAlongX = [&](Point2 at) {
    const auto onSurface = [&](double x) {
      return map.lift(placeOf(*chart.transformToSurface(at + Point2{x, 0}))).position;
    };
    return distance(onSurface(-0.01), onSurface(0.01)) / 0.02;
  };
  const double here = lengthAlongX({0.47, 0});
  for (const Point2 off : {Point2{0.3, 0.6}, Point2{-0.3, 0.6}, Point2{0.4, -0.3}}) {
    const double there = lengthAlongX(Point2{0.47, 0} + off);
    const double byScale = map.scaleAt({2.1, 1.2}) /
                           map.scaleAt(placeOf(*chart.transformToSurface(Point2{0.47, 0} + off)));
    EXPECT_LT(std::abs(there / here - 1), 0.25 * std::abs(byScale - 1) + 1e-3);
  }
}

TEST_F(ConformalCharts, TheBoxOfAWindowHoldsWhatItShows) {
  const StepChart step(chart, 0.3);
  for (const Window& window : {Window{-1, -0.2, 2, 2}, Window{-4, -3, 5, 6}}) {
    const Box3 box = step.boxOf(window, from.position);
    for (int i = 0; i <= 30; ++i)
      for (int j = 0; j <= 30; ++j) {
        const auto p =
            chart.transformToSurface({window.lowX + (window.highX - window.lowX) * i / 30,
                                      window.lowY + (window.highY - window.lowY) * j / 30});
        EXPECT_TRUE(p->position.x >= box.low.x && p->position.x <= box.high.x &&
                    p->position.y >= box.low.y && p->position.y <= box.high.y);
      }
  }
}

/// Lengths that change so fast that the chart turns inside out not far off.
TEST(ConformalChart, PutsWhatIsBeyondItsPoleOutside) {
  const TorusMap map(kFrame, TorusSurface(kFrame.origin, kFrame.axis, 1, 0.98, Side::Outer));
  const SurfacePoint from = pointInPlane({0, 1}), to = pointInPlane({0.8, 1});
  const ConformalChart chart(map, from, to, 0.8);
  int farPlaces = 0;
  for (const double y : {-40.0, -12.0, 12.0, 40.0}) {
    const ChartPoint p = chart.transformFromSurface(pointInPlane({0.3, 1 + y}));
    if (p.view == ChartView::Legal) continue;
    ++farPlaces;
    EXPECT_GT(length(p.position), 12 / 0.8);
    EXPECT_GT(p.position.y * y, 0);  // on its own side
  }
  EXPECT_GT(farPlaces, 0);
}

}  // namespace
}  // namespace af2::geometry
