// Volume entities of Gmsh's format.
#include "geometry/formats/msh_volumes.h"

#include <gtest/gtest.h>

#include "tests/support/small_meshes.h"
#include "tests/support/written.h"

namespace af2::geometry {
namespace {

TEST(MshVolumes, AreBoundedByTheFacesOfTheSolid) {
  ModelMesh mesh = cubeMesh();
  mesh.groups = {{"1", GroupKind::Solid, {1, 2, 3, 4, 5, 6}, {2, 6}}};
  for (Element& element : mesh.elements) {
    const int face = mesh.face[static_cast<std::size_t>(&element - mesh.elements.data())];
    if (face == 2) std::swap(element.corners[0], element.corners[1]);
    if (face == 6) std::swap(element.corners[1], element.corners[3]);
  }
  const std::vector<MshVolume> volumes = mshVolumes(mesh);
  ASSERT_EQ(volumes.size(), 1u);
  EXPECT_EQ(volumes[0].number, 1);
  EXPECT_EQ(volumes[0].surfaces, (std::vector<std::int32_t>{1, -2, 3, 4, 5, -6}));
}

TEST(MshVolumes, HaveTheNameOfThePartThatIsTheSolid) {
  ModelMesh mesh = cubeMesh();
  const std::vector<int> all{1, 2, 3, 4, 5, 6};
  mesh.groups = {{"lid and more", GroupKind::Part, {5, 6}},
                 {"cube", GroupKind::Part, all},
                 {"1", GroupKind::Solid, all}};
  ASSERT_EQ(mshVolumes(mesh).size(), 1u);
  EXPECT_EQ(mshVolumes(mesh)[0].name, "cube");
  EXPECT_NE(testing::written(mesh, ".msh").find("3 1 \"cube (volume)\""), std::string::npos);
  mesh.groups.erase(mesh.groups.begin() + 1);
  EXPECT_EQ(mshVolumes(mesh)[0].name, "solid 1");
}

TEST(MshVolumes, ASurfaceOfTrianglesHasOneWithoutASolid) {
  ModelMesh mesh = cubeMesh();
  mesh.groups.clear();
  ASSERT_EQ(mshVolumes(mesh).size(), 1u);
  EXPECT_EQ(mshVolumes(mesh)[0].name, "volume 1");
}

TEST(MshVolumes, AnOpenMeshHasNone) {
  ModelMesh mesh = cubeMesh();
  mesh.elements.pop_back();
  mesh.face.pop_back();
  EXPECT_TRUE(mshVolumes(mesh).empty());
}

}  // namespace
}  // namespace af2::geometry
