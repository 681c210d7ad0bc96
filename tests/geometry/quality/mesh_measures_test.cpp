#include "geometry/quality/mesh_measures.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/support/planar_meshes.h"

namespace af2::geometry {
namespace {

/// A triangle in three blocks of n by n, each between the centre, a corner and the middles of the
/// sides beside it. Three quadrilaterals meet at the centre.
ModelMesh triangleInThreeBlocks(std::size_t n) {
  ModelMesh mesh;
  const auto at = [](double turns, double radius) {
    const double angle = 2 * std::numbers::pi * turns;
    return Point3{radius * std::cos(angle), radius * std::sin(angle), 0};
  };
  const auto vertex = [&](const Point3& p) {
    for (std::size_t i = 0; i < mesh.vertices.size(); ++i)
      if (distance(mesh.vertices[i], p) < 1e-9) return i;
    mesh.vertices.push_back(p);
    return mesh.vertices.size() - 1;
  };
  const double side = static_cast<double>(n);
  for (int block = 0; block < 3; ++block) {
    const Point3 before = at(block / 3.0, 1), corner = at((block + 0.5) / 3.0, 2),
                 after = at((block + 1) / 3.0, 1);
    const auto id = [&](std::size_t i, std::size_t j) {
      const double u = static_cast<double>(i) / side, v = static_cast<double>(j) / side;
      return vertex((u * (1 - v)) * before + (u * v) * corner + (v * (1 - u)) * after);
    };
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = 0; j < n; ++j)
        addElements(mesh, {{id(i, j), id(i + 1, j), id(i + 1, j + 1), id(i, j + 1)}});
  }
  return mesh;
}

TEST(MeshMeasures, OfAGridOfSquaresAreIdeal) {
  const MeshMeasures m = measureMesh(squareGrid(4));
  EXPECT_EQ(m.quads, 16u);
  EXPECT_EQ(m.vertices, 25u);
  EXPECT_EQ(m.quadShare(), 1);
  EXPECT_NEAR(m.quadJacobian.min, 1, 1e-15);
  EXPECT_NEAR(m.quadAngles.min, 90, 1e-12);
  EXPECT_NEAR(m.quadAngles.max, 90, 1e-12);
  EXPECT_NEAR(m.aspect.max, 1, 1e-15);
  EXPECT_EQ(m.inverted, 0u);
  EXPECT_EQ(m.irregular.irregular(), 0u);
  EXPECT_EQ(m.irregular.least, 0u);
  EXPECT_EQ(m.irregular.boundary.all, 16u);
  EXPECT_EQ(m.spokes.count, 12u);
  EXPECT_NEAR(m.spokes.max, 0, 1e-12);
  EXPECT_EQ(m.shape.freeEdges, 16u);
  EXPECT_EQ(m.shape.euler, 1);
  EXPECT_FALSE(m.shape.isClosed());
  EXPECT_EQ(m.shape.components, 1u);
}

TEST(MeshMeasures, FindTheOneIrregularVertex) {
  const MeshMeasures m = measureMesh(triangleInThreeBlocks(4));
  EXPECT_EQ(m.irregular.inner.irregular, 1u);
  EXPECT_EQ(m.irregular.boundary.irregular, 0u);
  EXPECT_EQ(m.irregular.least, 1u) << "three corners instead of four";
  EXPECT_EQ(m.irregular.rings[4].irregular, 1u) << "four edges from the boundary";
  EXPECT_EQ(m.irregular.rings[0].all, m.irregular.boundary.all);
}

TEST(MeshMeasures, CountTheRingsOfIrregularVertices) {
  EXPECT_EQ(measureMesh(triangleInThreeBlocks(1)).irregular.rings[1].irregular, 1u);
  EXPECT_EQ(measureMesh(triangleInThreeBlocks(3)).irregular.rings[3].irregular, 1u);
}

TEST(MeshMeasures, FindWhereFrontsMeet) {
  const MeshMeasures even = measureMesh(squareGrid(5)), odd = measureMesh(squareGrid(6));
  // The diagonals, as far as vertices inside lie on them.
  EXPECT_EQ(even.meeting.irregular.all, 8u);
  EXPECT_EQ(even.meeting.irregularElsewhere.all, 8u);
  EXPECT_EQ(odd.meeting.irregular.all, 9u);
  EXPECT_EQ(odd.meeting.jacobian.count + odd.meeting.jacobianElsewhere.count, 36u);
  const MeshMeasures blocks = measureMesh(triangleInThreeBlocks(4));
  EXPECT_EQ(blocks.meeting.irregular.irregular, 1u);
  EXPECT_EQ(blocks.meeting.irregularElsewhere.irregular, 0u);
  EXPECT_EQ(measureMesh(squareCube(false)).meeting.jacobian.count, 0u) << "without a boundary";
}

TEST(MeshMeasures, OfACubeWithoutFacesHasEightVerticesOfThreeElements) {
  const MeshMeasures m = measureMesh(squareCube(false));
  EXPECT_EQ(m.irregular.inner.all, 8u);
  EXPECT_EQ(m.irregular.inner.irregular, 8u);
  EXPECT_EQ(m.irregular.least, 8u);
  EXPECT_EQ(m.irregular.rings[4].irregular, 8u);
  EXPECT_TRUE(m.shape.isClosed());
  EXPECT_EQ(m.shape.euler, 2);
}

TEST(MeshMeasures, TakeEdgesBetweenFacesForBoundaries) {
  const MeshMeasures m = measureMesh(squareCube(true));
  EXPECT_EQ(m.irregular.boundary.all, 8u);
  EXPECT_EQ(m.irregular.irregular(), 0u);
  EXPECT_EQ(m.irregular.least, 0u);
  EXPECT_EQ(m.shape.faces, 6u);
  EXPECT_EQ(m.shape.regions, 6u);
  EXPECT_EQ(m.shape.components, 1u);
}

TEST(MeshMeasures, TakeSharpEdgesForBoundariesOnRequest) {
  EXPECT_EQ(measureMesh(squareCube(false), {0, 40}).irregular.boundary.all, 8u);
  EXPECT_EQ(measureMesh(squareCube(false), {0, 95}).irregular.boundary.all, 0u);
}

TEST(MeshMeasures, TakeSegmentsForBoundaries) {
  ModelMesh mesh = squareGrid(2);
  EXPECT_EQ(measureMesh(mesh).shape.regions, 1u);
  mesh.segments = {{VertexId(1), VertexId(4), 1, 2, {}}, {VertexId(7), VertexId(4), 1, 2, {}}};
  const MeshMeasures m = measureMesh(mesh);
  EXPECT_EQ(m.shape.regions, 2u);
  EXPECT_EQ(m.irregular.boundary.all, 9u);
  EXPECT_EQ(m.irregular.irregular(), 0u);
}

TEST(MeshMeasures, OfTrianglesKnowSixAroundAVertex) {
  ModelMesh mesh;
  mesh.vertices.push_back({});
  for (int i = 0; i < 6; ++i)
    mesh.vertices.push_back(
        {std::cos(i * std::numbers::pi / 3), std::sin(i * std::numbers::pi / 3), 0});
  for (std::size_t i = 0; i < 6; ++i) addElements(mesh, {{0, i + 1, (i + 1) % 6 + 1}});
  const MeshMeasures m = measureMesh(mesh);
  EXPECT_EQ(m.irregular.irregular(), 0u);
  EXPECT_EQ(m.irregular.least, 0u);
  EXPECT_NEAR(m.triangleJacobian.min, 1, 1e-14);
  EXPECT_NEAR(m.lengths.max, 1, 1e-14);
}

TEST(MeshMeasures, CompareTheSpokesOfTrianglesWithThirdsOfTheAngle) {
  // Three equilateral triangles on a straight boundary: the spokes have 60 and 120 degrees.
  const double h = std::sqrt(3.0) / 2;
  ModelMesh mesh = withVertices({{-1, 0, 0}, {0, 0, 0}, {1, 0, 0}, {0.5, h, 0}, {-0.5, h, 0}});
  addElements(mesh, {{1, 2, 3}, {1, 3, 4}, {1, 4, 0}});
  const MeshMeasures regular = measureMesh(mesh);
  EXPECT_EQ(regular.spokes.count, 2u);
  EXPECT_NEAR(regular.spokes.max, 0, 1e-12);
  mesh.vertices[3] = {0.5 + 0.1, h, 0};
  EXPECT_NEAR(measureMesh(mesh).spokes.max, 60 - std::atan2(h, 0.6) * 180 / std::numbers::pi, 1e-9);
}

TEST(MeshMeasures, MeasureSpokesFromTheNormal) {
  ModelMesh mesh =
      withVertices({{-1, 0, 0}, {0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {1, 1, 0}, {-1, 1, 0}});
  mesh.vertices[4] = {std::tan(10 * std::numbers::pi / 180), 1, 0};
  addElements(mesh, {{1, 2, 3, 4}, {0, 1, 4, 5}});
  const MeshMeasures m = measureMesh(mesh);
  EXPECT_EQ(m.spokes.count, 2u) << "at the bottom and at the top";
  EXPECT_NEAR(m.spokes.max, 10, 1e-9);
}

TEST(MeshMeasures, CountInvertedElementsOfPlanarMeshes) {
  ModelMesh mesh = withVertices({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0.9, 0.5, 0}});
  addElements(mesh, {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}});
  EXPECT_EQ(measureMesh(mesh).inverted, 0u);
  mesh.vertices[4].x = 1.1;
  EXPECT_EQ(measureMesh(mesh).inverted, 1u);
  EXPECT_LT(measureMesh(mesh).triangleJacobian.min, 0);
  for (Element& element : mesh.elements) std::swap(element.corners[0], element.corners[1]);
  EXPECT_EQ(measureMesh(mesh).inverted, 1u) << "the mesh as a whole may be seen from below";
}

TEST(MeshMeasures, CountEdgesThatNoSurfaceHas) {
  ModelMesh mesh = withVertices({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}});
  addElements(mesh, {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}});
  EXPECT_EQ(measureMesh(mesh).shape.nonManifoldEdges, 1u);
  mesh.elements.pop_back();
  mesh.face.pop_back();
  std::swap(mesh.elements[1].corners[0], mesh.elements[1].corners[1]);
  EXPECT_EQ(measureMesh(mesh).shape.turnedEdges, 1u);
}

TEST(MeshMeasures, DivideLengthsBySizes) {
  ModelMesh mesh = squareGrid(2);
  EXPECT_EQ(measureMesh(mesh).lengthUnit, LengthReference::MedianLength);
  EXPECT_NEAR(measureMesh(mesh, {2, 180}).lengths.median, 0.5, 1e-15);
  mesh.wantedSizes.assign(9, 4);
  EXPECT_NEAR(measureMesh(mesh).lengths.max, 0.25, 1e-15);
  EXPECT_EQ(measureMesh(mesh).lengthUnit, LengthReference::WantedSizes);
}

TEST(MeshMeasures, OfAnEmptyMeshAreZero) {
  const MeshMeasures m = measureMesh({});
  EXPECT_EQ(m.elements(), 0u);
  EXPECT_EQ(m.quadShare(), 0);
}

}  // namespace
}  // namespace af2::geometry
