#include "geometry/faceted/nearest_on_facets.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "engine/base/error.h"

namespace af2::geometry {
namespace {

/// A tetrahedron with corners on the axes.
Facets cornerOfCube() {
  Facets facets;
  facets.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  facets.triangles = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
  return facets;
}

TEST(NearestOnFacets, AreInsideOnEdgesAndAtCorners) {
  const std::vector<Point3> points{{1, 1, 1}, {0.2, 0.3, -1}, {0.5, -1, -1}, {3, -1, -1}};
  const auto nearest = nearestPoints(cornerOfCube(), points);
  ASSERT_EQ(nearest.size(), 4u);
  EXPECT_NEAR(distance(nearest[0].position, {1 / 3., 1 / 3., 1 / 3.}), 0, 1e-15);
  EXPECT_NEAR(distance(nearest[0].normal, unit({1, 1, 1})), 0, 1e-15);
  EXPECT_EQ(nearest[0].triangle, 2u);
  EXPECT_NEAR(distance(nearest[1].position, {0.2, 0.3, 0}), 0, 1e-15);
  EXPECT_EQ(nearest[1].normal, (Point3{0, 0, -1}));
  EXPECT_EQ(nearest[2].position, (Point3{0.5, 0, 0}));
  EXPECT_EQ(nearest[2].triangle, 0u);  // the first of two
  EXPECT_EQ(nearest[3].position, (Point3{1, 0, 0}));
}

TEST(NearestOnFacets, DoNotDependOnThreads) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> coordinate(-2, 2);
  std::vector<Point3> points(5000);
  for (Point3& p : points) p = {coordinate(random), coordinate(random), coordinate(random)};
  const auto alone = nearestPoints(cornerOfCube(), points, 1);
  const auto together = nearestPoints(cornerOfCube(), points, 4);
  for (std::size_t i = 0; i < points.size(); ++i) {
    EXPECT_EQ(alone[i].position, together[i].position);
    EXPECT_EQ(alone[i].triangle, together[i].triangle);
  }
}

TEST(NearestOnFacets, RefuseWhatIsNoPoint) {
  EXPECT_THROW(nearestPoints(cornerOfCube(), std::vector<Point3>{{NAN, 0, 0}}), InputError);
  EXPECT_THROW(nearestPoints(Facets(), std::vector<Point3>{{0, 0, 0}}), InputError);
}

}  // namespace
}  // namespace af2::geometry
