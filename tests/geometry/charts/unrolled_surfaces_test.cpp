#include "geometry/charts/unrolled_surfaces.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/geometry/charts/charts.h"

namespace af2::geometry {
namespace {

using testing::kFrame;
using testing::kLeftHanded;

/// Lengths and angles are kept, positions come back, and seen from the side to which its normals
/// point the face lies in the plane as it is.
void expectIsometry(const UnrolledSurface& surface, Point2 middle) {
  const UnrolledMap map(surface);
  constexpr double kStep = 1e-5;
  for (const Point2 off : {Point2{0, 0}, Point2{0.3, 0.4}, Point2{-0.5, 0.2}}) {
    const Point2 place = middle + off;
    const SurfacePoint point = map.lift(place);
    EXPECT_LT(testing::gap(map.flatten(point), place), 1e-13);
    EXPECT_NEAR(length(point.normal), 1, 1e-14);
    const Point3 x = (0.5 / kStep) * (map.lift(place + Point2{kStep, 0}).position -
                                      map.lift(place - Point2{kStep, 0}).position);
    const Point3 y = (0.5 / kStep) * (map.lift(place + Point2{0, kStep}).position -
                                      map.lift(place - Point2{0, kStep}).position);
    EXPECT_NEAR(length(x), 1, 1e-9);
    EXPECT_NEAR(length(y), 1, 1e-9);
    EXPECT_NEAR(dot(x, y), 0, 1e-9);
    EXPECT_GT(dot(cross(x, y), point.normal), 0.999);
  }
}

TEST(UnrolledCylinder, IsAnIsometry) {
  for (const Side side : {Side::Outer, Side::Inner})
    for (const AxisFrame& frame : {kFrame, kLeftHanded})
      expectIsometry(UnrolledCylinder(frame, CylinderSurface(frame.origin, frame.axis, 2, side)),
                     {11, -3});
}

TEST(UnrolledCylinder, KnowsTheTurnByTheParameterAndThePlaceByThePosition) {
  const UnrolledCylinder cylinder(kFrame,
                                  CylinderSurface(kFrame.origin, kFrame.axis, 2, Side::Outer));
  const SurfacePoint point = cylinder.pointAt(2 * 0.25, 7);
  // Parameters that are a little wrong, on the next turn.
  const Point2 place = cylinder.develop(point.position, 0.3 + 2 * kPi, 6.9);
  EXPECT_LT(testing::gap(place, {2 * (0.25 + 2 * kPi), 7}), 1e-13);
}

TEST(UnrolledCone, IsAnIsometry) {
  for (const Side side : {Side::Outer, Side::Inner})
    for (const AxisFrame& frame : {kFrame, kLeftHanded})
      expectIsometry(
          UnrolledCone(frame, 0.4, 1.5, ConeSurface(frame.origin, frame.axis, std::tan(0.4), side)),
          {2, 0.1});
}

TEST(UnrolledCone, HasItsTipAtTheOrigin) {
  const UnrolledCone cone(kFrame, 0.4, kPi,
                          ConeSurface(kFrame.origin, kFrame.axis, std::tan(0.4), Side::Outer));
  EXPECT_EQ(cone.pointAt(0, 0).position, kFrame.origin);
  EXPECT_LT(testing::gap(cone.develop(kFrame.origin, 2.5, 0), {0, 0}), 1e-15);
}

TEST(UnrolledCone, GivesBackWhatItDevelops) {
  const UnrolledCone cone(kFrame, 0.4, kPi,
                          ConeSurface(kFrame.origin, kFrame.axis, std::tan(0.4), Side::Outer));
  for (const double angle : {0.0, 1.0, kPi, 6.28}) {
    const Point3 position =
        kFrame.origin + 3.0 * kFrame.axis + (3 * std::tan(0.4)) * kFrame.radial(angle);
    const Point2 place = cone.develop(position, angle, 0);
    EXPECT_LT(testing::gap(cone.pointAt(place.x, place.y).position, position), 1e-13);
  }
}

}  // namespace
}  // namespace af2::geometry
