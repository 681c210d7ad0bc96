// Curves that are added inside faces.
#include "geometry/occ/model/curves_inside.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "engine/base/error.h"
#include "geometry/mesh/quality.h"
#include "geometry/occ/faces/solid_volume.h"
#include "geometry/occ/model/points_inside.h"
#include "tests/geometry/occ/meshing.h"
#include "tests/support/model_mesh.h"

namespace af2::geometry {
namespace {

using Curves = std::vector<std::vector<Point3>>;

/// Complete and closed, with all segments of the new edges.
ModelMesh closedMesh(const Model& model, double size) {
  ModelMesh mesh = testing::mesh(model, testing::ofSize(size));
  testing::expectComplete(mesh);
  EXPECT_EQ(measureQuality(mesh).freeEdges, 0u);
  return mesh;
}

double lengthOfEdges(const ModelMesh& mesh, int above) {
  double length = 0;
  for (const EdgeSegment& segment : mesh.segments)
    if (segment.edge > above)
      length += distance(mesh.vertices[segment.from.value], mesh.vertices[segment.to.value]);
  return length;
}

TEST(CurvesInside, BecomeEdgesOfPlaneFaces) {
  const Model box = testing::box(4, 5, 6);
  const Model model = withCurvesInside(box, Curves{{{1, 1, 0}, {3, 1, 0}, {3, 4, 0}}});
  EXPECT_EQ(model.edgeCount(), box.edgeCount() + 2);
  EXPECT_NEAR(volumeOfSolids(model.shape()).value_or(0), 120, 1e-9);
  const ModelMesh mesh = closedMesh(model, 0.6);
  EXPECT_NEAR(lengthOfEdges(mesh, box.edgeCount()), 5, 1e-9);
  EXPECT_NEAR(testing::areaOf(mesh), 148, 1e-9);
  for (const EdgeSegment& segment : mesh.segments) EXPECT_EQ(segment.uses, 2);
}

TEST(CurvesInside, LieOnCurvedFacesAndMayEndOnEdges) {
  const Model cylinder = testing::cylinder(2, 6);
  const auto at = [](double angle, double z) {
    return Point3{2 * std::cos(angle), 2 * std::sin(angle), z};
  };
  const Model model =
      withCurvesInside(cylinder, Curves{{at(1, 0), at(1, 3), at(2.5, 4)}, {at(4, 1), at(4.5, 5)}});
  const ModelMesh mesh = closedMesh(model, 0.5);
  std::set<VertexId> along;
  for (const EdgeSegment& segment : mesh.segments)
    if (segment.edge > cylinder.edgeCount()) along.insert({segment.from, segment.to});
  EXPECT_GT(along.size(), 20u);
  for (const VertexId v : along)
    EXPECT_NEAR(std::hypot(mesh.vertices[v.value].x, mesh.vertices[v.value].y), 2, 1e-6);
}

TEST(CurvesInside, MayPassEdgesAtAPoint) {
  const Model box = testing::box(4, 5, 6);
  const Model model =
      withCurvesInside(box, Curves{{{2, 2, 0}, {2, 0, 0}, {2, 0, 3}}, {{0, 0, 0}, {2, 2, 0}}});
  const ModelMesh mesh = closedMesh(model, 0.8);
  EXPECT_NEAR(lengthOfEdges(mesh, box.edgeCount()), 5 + std::sqrt(8.0), 1e-9);
}

TEST(CurvesInside, GoTogetherWithPoints) {
  const Model box = testing::box(4, 5, 6);
  const std::vector<Point3> points{{1, 4, 0}};
  const Model model = withCurvesInside(withPointsInside(box, points),
                                       Curves{{{1, 1, 0}, {3, 1, 0}}, {{0, 2, 2}, {0, 3, 4}}});
  const ModelMesh mesh = closedMesh(model, 0.8);
  EXPECT_NE(std::ranges::find(mesh.vertices, points[0]), mesh.vertices.end());
  EXPECT_NEAR(lengthOfEdges(mesh, box.edgeCount()), 2 + std::sqrt(5.0), 1e-9);
}

TEST(CurvesInside, AreRefusedWhereTheyLeaveTheFaces) {
  const Model box = testing::box(4, 5, 6);
  const auto isRefused = [&](const std::vector<Point3>& curve) {
    EXPECT_THROW(withCurvesInside(box, Curves{curve}), InputError);
  };
  isRefused({{1, 1, 0}});
  isRefused({{1, 1, 0}, {1, 1, 0}});
  isRefused({{1, 1, 0}, {1, 1, 3}});
  isRefused({{2, 2, 0}, {2, 0, 3}});
  isRefused({{1, 1, 0}, {9, 1, 0}});
  isRefused({{0, 0, 0}, {4, 0, 0}});
  EXPECT_EQ(&withCurvesInside(box, {}).shape(), &box.shape());
}

}  // namespace
}  // namespace af2::geometry
