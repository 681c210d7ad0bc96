#include "geometry/occ/inspect/measures.h"

#include <gtest/gtest.h>
#include <algorithm>
#include <numbers>

#include "tests/geometry/occ/shapes.h"

namespace af2::geometry {
namespace {

using std::numbers::pi;

void expectNear(const Point3& a, const Point3& b) { EXPECT_LT(distance(a, b), 1e-9); }

TEST(Measures, OfABoxAreExact) {
  const Model model = testing::box(4, 3, 2);
  const auto faces = measuresOfFaces(model);
  ASSERT_EQ(faces.size(), 6u);
  double area = 0;
  for (const auto& face : faces) {
    ASSERT_TRUE(face);
    area += face->area;
    EXPECT_EQ(face->greatestCurvature, 0);
    EXPECT_EQ(face->neighbors.size(), 4u);
    EXPECT_EQ(face->edges.size(), 4u);
    expectNear(face->centroid, 0.5 * (face->low + face->high));
  }
  EXPECT_NEAR(area, 2 * (12 + 8 + 6), 1e-12);
  expectNear(faces[0]->centroid, {0, 1.5, 1});  // x = 0
  expectNear(faces[0]->high, {0, 3, 2});
  const std::vector<SolidMeasures> solids = measuresOfSolids(model);
  ASSERT_EQ(solids.size(), 1u);
  EXPECT_NEAR(solids[0].volume, 24, 1e-12);
  expectNear(solids[0].centroid, {2, 1.5, 1});
  expectNear(solids[0].high, {4, 3, 2});
  EXPECT_EQ(solids[0].faces.size(), 6u);
}

TEST(Measures, OfACylinderAreExact) {
  const auto faces = measuresOfFaces(testing::cylinder(2, 5));
  ASSERT_EQ(faces.size(), 3u);
  EXPECT_NEAR(faces[0]->area, 2 * pi * 2 * 5, 1e-9);
  EXPECT_NEAR(faces[0]->leastCurvature, 0.5, 1e-12);
  EXPECT_NEAR(faces[0]->greatestCurvature, 0.5, 1e-12);
  EXPECT_NEAR(faces[1]->area, pi * 4, 1e-9);
  EXPECT_EQ(faces[0]->neighbors, (std::vector<int>{2, 3}));
  EXPECT_NEAR(faces[0]->place.x * faces[0]->place.x + faces[0]->place.y * faces[0]->place.y, 4,
              1e-9)
      << "the centroid is on the axis, the place on the face";
}

TEST(Measures, OfATorusHaveARangeOfCurvature) {
  const auto faces = measuresOfFaces(testing::torus(3, 1));
  ASSERT_EQ(faces.size(), 1u);
  EXPECT_NEAR(faces[0]->area, 4 * pi * pi * 3, 1e-6);
  EXPECT_NEAR(faces[0]->leastCurvature, 1, 1e-9);
  EXPECT_TRUE(faces[0]->neighbors.empty());
}

TEST(Measures, OfTheDieAddUpToThoseOfItsSolid) {
  const Model model = readModel("examples/models/die.step");
  const auto faces = measuresOfFaces(model);
  const std::vector<SolidMeasures> solids = measuresOfSolids(model);
  ASSERT_EQ(solids.size(), 1u);
  EXPECT_EQ(solids[0].faces.size(), faces.size());
  Point3 low = faces[0]->low, high = faces[0]->high;
  for (const auto& face : faces) {
    ASSERT_TRUE(face);
    low = {std::min(low.x, face->low.x), std::min(low.y, face->low.y),
           std::min(low.z, face->low.z)};
    high = {std::max(high.x, face->high.x), std::max(high.y, face->high.y),
            std::max(high.z, face->high.z)};
    for (const int other : face->neighbors)
      EXPECT_TRUE(
          std::ranges::count(faces[static_cast<std::size_t>(other) - 1]->neighbors, face->id));
  }
  EXPECT_LT(distance(low, solids[0].low), 1e-6);
  EXPECT_LT(distance(high, solids[0].high), 1e-6);
}

}  // namespace
}  // namespace af2::geometry
