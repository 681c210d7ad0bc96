// Vertices that are added inside faces.
#include "geometry/occ/model/points_inside.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "engine/base/error.h"
#include "geometry/mesh/quality.h"
#include "geometry/occ/faces/solid_volume.h"
#include "tests/geometry/occ/meshing.h"
#include "tests/support/model_mesh.h"

namespace af2::geometry {
namespace {

TEST(PointsInside, BecomeVerticesOfPlaneAndCurvedFaces) {
  const std::vector<Point3> points{
      {1, 0.5, 0}, {-1, 2, 10}, {5 * std::cos(1.0), 5 * std::sin(1.0), 4}};
  const Model model = withPointsInside(testing::cylinder(5, 10), points);
  EXPECT_EQ(model.faceCount(), 3);
  const ModelMesh mesh = testing::mesh(model, testing::ofSize(2));
  testing::expectComplete(mesh);
  EXPECT_EQ(measureQuality(mesh).freeEdges, 0u);
  for (const Point3& p : points) {
    const auto at = std::ranges::find(mesh.vertices, p);
    ASSERT_NE(at, mesh.vertices.end());
    const VertexId id(static_cast<std::size_t>(at - mesh.vertices.begin()));
    EXPECT_TRUE(std::ranges::any_of(mesh.elements, [&](const Element& element) {
      return std::ranges::count(element.vertices(), id) > 0;
    }));
  }
}

/// Faces that look backwards keep their boundaries as they are.
TEST(PointsInside, LeaveTheVolume) {
  const std::vector<Point3> points{{0.5, 1, 0}, {0.5, 1, 3}, {0, 1, 1},
                                   {1, 1, 1},   {0.5, 0, 1}, {0.5, 2, 1}};
  const Model model = withPointsInside(testing::box(1, 2, 3), points);
  EXPECT_NEAR(volumeOfSolids(model.shape()).value_or(0), 6, 1e-9);
}

TEST(PointsInside, AreRefusedOffTheFacesAndOnEdges) {
  const Model model = testing::box(1, 2, 3);
  EXPECT_THROW(withPointsInside(model, std::vector<Point3>{{0.5, 0.5, 0.5}}), InputError);
  EXPECT_THROW(withPointsInside(model, std::vector<Point3>{{0.5, 0, 0}}), InputError);
}

TEST(PointsInside, LeaveTheModelAsItIsIfThereAreNone) {
  const Model model = testing::box(1, 2, 3);
  EXPECT_EQ(&withPointsInside(model, {}).shape(), &model.shape());
}

}  // namespace
}  // namespace af2::geometry
