#include "geometry/charts/quadric_surfaces.h"

#include <gtest/gtest.h>

#include <random>

namespace af2::geometry {
namespace {

/// Points of a surface, with a line through each that is tilted against the normal.
template <class Surface>
void expectLinesComeBack(const Surface& surface, const std::vector<Point3>& points) {
  std::mt19937 random(20240601);
  std::uniform_real_distribution<double> any(-1, 1);
  for (const Point3& p : points) {
    const Point3 normal = surface.normalAt(p);
    for (int i = 0; i < 20; ++i) {
      const Point3 direction = unit(normal + 0.5 * Point3{any(random), any(random), any(random)});
      const Point3 start = p + 0.1 * any(random) * direction;
      const SurfacePoint unused{p, normal};
      const auto hit = surface.hit({start, direction, {}, {}, unused, unused, 1});
      ASSERT_TRUE(hit);
      EXPECT_LT(distance(hit->position, p), 1e-12);
      EXPECT_LT(distance(hit->normal, normal), 1e-12);
    }
  }
}

TEST(CylinderSurface, MeetsLinesWhereTheyCross) {
  const double c = std::cos(0.7), s = std::sin(0.7);
  for (const Side side : {Side::Outer, Side::Inner})
    expectLinesComeBack(CylinderSurface({1, 2, 3}, {0, 0, 1}, 2, side),
                        {{3, 2, 3}, {1, 4, -5}, {1 + 2 * c, 2 + 2 * s, 0}});
}

TEST(SphereSurface, MeetsLinesWhereTheyCross) {
  for (const Side side : {Side::Outer, Side::Inner})
    expectLinesComeBack(SphereSurface({1, 2, 3}, 2, side), {{3, 2, 3}, {1, 2, 5}, {1, 0, 3}});
}

TEST(ConeSurface, MeetsLinesWhereTheyCross) {
  for (const Side side : {Side::Outer, Side::Inner})
    expectLinesComeBack(ConeSurface({0, 0, 1}, {0, 0, -1}, 0.5, side),
                        {{1, 0, -1}, {0, -0.5, 0}, {2, 0, -3}});
}

TEST(TorusSurface, MeetsLinesWhereTheyCross) {
  const double c = std::cos(2.1), s = std::sin(2.1);
  for (const Side side : {Side::Outer, Side::Inner})
    expectLinesComeBack(TorusSurface({0, 0, 0}, {0, 0, 1}, 3, 1, side),
                        {{4, 0, 0}, {0, 2, 0}, {3, 0, 1}, {3 + c, 0, s}});
}

TEST(ConeSurface, HasTheMeanNormalAtItsApex) {
  const ConeSurface cone({0, 0, 0}, {0, 0, 1}, 1, Side::Outer);
  EXPECT_EQ(cone.normalAt({0, 0, 0}), (Point3{0, 0, -1}));
  const ConeSurface needle({0, 0, 0}, {0, 0, 1}, 0.1, Side::Outer);
  EXPECT_EQ(needle.normalAt({0, 0, 0}), (Point3{0, 0, 0}));
}

TEST(ConeSurface, IsNotMetOnItsOtherNappe) {
  const ConeSurface cone({0, 0, 0}, {0, 0, 1}, 1, Side::Outer);
  const SurfacePoint unused;
  EXPECT_FALSE(cone.hit({{1, 0, -1}, {1, 0, 0}, {}, {}, unused, unused, 1}));
}

TEST(TorusSurface, IsCurvedByItsTubeOutsideAndByItsHoleWhereThatIsSmaller) {
  const TorusSurface thick({0, 0, 0}, {0, 0, 1}, 3, 2.5, Side::Outer);
  EXPECT_DOUBLE_EQ(thick.curvatureRadiusAt({5.5, 0, 0}), 2.5);
  EXPECT_DOUBLE_EQ(thick.curvatureRadiusAt({0.5, 0, 0}), 0.5);
  EXPECT_DOUBLE_EQ(thick.curvatureRadiusAt({3, 0, 2.5}), 2.5);
}

}  // namespace
}  // namespace af2::geometry
