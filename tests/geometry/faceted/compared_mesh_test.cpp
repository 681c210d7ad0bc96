#include "geometry/faceted/compared_mesh.h"

#include <gtest/gtest.h>

#include "tests/geometry/faceted/faceted_mesh.h"

namespace af2::geometry {
namespace {

Facets tetrahedron() {
  Facets facets;
  facets.vertices = {{0, 0, 0}, {3, 0, 0}, {0, 3, 0}, {0, 0, 3}};
  facets.triangles = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
  return facets;
}

void dropLastElement(ModelMesh& mesh) {
  mesh.elements.pop_back();
  mesh.face.pop_back();
  mesh.origins.pop_back();
}

TEST(ComparedMesh, IsToldIfItIsOpenOnClosedTriangles) {
  ModelMesh mesh = testing::completeMesh(tetrahedron(), 1);
  EXPECT_TRUE(mesh.findings.empty());
  dropLastElement(mesh);
  compareWithTriangles(tetrahedron(), mesh);
  ASSERT_EQ(mesh.findings.size(), 1u);
  EXPECT_NE(mesh.findings[0].find("open, with 3 free edges"), std::string::npos)
      << mesh.findings[0];
}

TEST(ComparedMesh, MayBeOpenWhereTheTrianglesAre) {
  Facets open = tetrahedron();
  open.triangles.pop_back();
  ModelMesh mesh = testing::completeMesh(open, 1);
  EXPECT_TRUE(mesh.findings.empty());
}

TEST(ComparedMesh, MayBeOpenWhereAFaceFailed) {
  ModelMesh mesh = testing::completeMesh(tetrahedron(), 1);
  dropLastElement(mesh);
  mesh.faces.back().status = FaceStatus::Failed;
  compareWithTriangles(tetrahedron(), mesh);
  EXPECT_TRUE(mesh.findings.empty());
}

}  // namespace
}  // namespace af2::geometry
