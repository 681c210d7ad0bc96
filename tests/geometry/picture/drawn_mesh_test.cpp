#include "geometry/picture/drawn_mesh.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/support/small_meshes.h"

namespace af2::geometry {
namespace {

using Side = DrawnTriangle::Side;

std::ptrdiff_t countOf(Side kind, const std::vector<DrawnTriangle>& triangles) {
  std::ptrdiff_t count = 0;
  for (const DrawnTriangle& triangle : triangles) count += std::ranges::count(triangle.sides, kind);
  return count;
}

TEST(DrawnMesh, DrawsNoDiagonalOfAQuadrilateral) {
  const ModelMesh mesh = oneElement({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}});
  const std::vector<DrawnTriangle> triangles = DrawnMesh(mesh).trianglesOf(0);
  EXPECT_EQ(triangles.size(), 2u);
  EXPECT_EQ(countOf(Side::Side, triangles), 4);
  EXPECT_EQ(countOf(Side::Inside, triangles), 2);
}

TEST(DrawnMesh, DrawsCurvedSidesAsTwoPieces) {
  ModelMesh mesh = oneElement({{0, 0, 0}, {2, 0, 0}, {0, 2, 0}});
  mesh.vertices.insert(mesh.vertices.end(), {{1, 0, 0}, {1, 1, 0}, {0, 1, 0}});
  mesh.midsides = {{VertexId(3), VertexId(4), VertexId(5), VertexId()}};
  const DrawnMesh drawn(mesh);
  EXPECT_EQ(drawn.sidesOf(0).size(), 6u);
  EXPECT_EQ(drawn.trianglesOf(0).size(), 4u);
  EXPECT_EQ(countOf(Side::Side, drawn.trianglesOf(0)), 6);
}

TEST(DrawnMesh, KnowsTheEdgesOfTheModel) {
  const ModelMesh mesh = cubeMesh();  // with edges around the lid, its last element
  EXPECT_EQ(countOf(Side::Outline, DrawnMesh(mesh).trianglesOf(mesh.elements.size() - 1)), 4);
  EXPECT_EQ(countOf(Side::Outline, DrawnMesh(mesh).trianglesOf(0)), 0);
}

TEST(DrawnMesh, IsPlanarInAPlaneOfConstantHeight) {
  EXPECT_TRUE(drawnBox(oneElement({{0, 0, 5}, {1, 0, 5}, {0, 1, 5}})).isPlanar());
  EXPECT_FALSE(drawnBox(cubeMesh()).isPlanar());
  EXPECT_TRUE(drawnBox({}).isPlanar());
}

}  // namespace
}  // namespace af2::geometry
