// Physical groups of Gmsh's formats.
#include "geometry/formats/msh_groups.h"

#include <gtest/gtest.h>

#include "tests/support/small_meshes.h"
#include "tests/support/written.h"

namespace af2::geometry {
namespace {

using testing::written;

constexpr std::int32_t kAll = 7, kHalf = 8, kRed = 9;  // after the faces 1 to 6

/// Faces 2 and 3 are called "wall", 6 is the "lid".
ModelMesh groupedCube() {
  ModelMesh mesh = cubeMesh();
  mesh.faces[1].name = mesh.faces[2].name = "wall";
  mesh.groups = {{"all", GroupKind::Part, {1, 2, 3, 4, 5, 6}},
                 {"half", GroupKind::Part, {1, 2, 4}},
                 {"#ff0000", GroupKind::Color, {5}}};
  return mesh;
}

using Numbers = std::vector<std::int32_t>;

TEST(MshGroups, FacesOfTheSameNameAreOne) {
  const ModelMesh mesh = groupedCube();
  const MshGroups groups(mesh, {}, {});
  EXPECT_EQ(groups.ofFace(2), (Numbers{2, kAll, kHalf}));
  EXPECT_EQ(groups.ofFace(3), (Numbers{2, kAll}));
  EXPECT_EQ(groups.names().at({PhysicalGroup::kSurface, 2}), "wall");
  EXPECT_FALSE(groups.names().contains({PhysicalGroup::kSurface, 3}));
}

TEST(MshGroups, ByKindsEachFaceHasTheFirstOneOfTheSmallest) {
  const ModelMesh mesh = groupedCube();
  const std::vector<Grouping> order{Grouping::Colors, Grouping::Parts};
  const MshGroups groups(mesh, {{}, order}, {});
  EXPECT_EQ(groups.ofFace(5), Numbers{kRed});
  EXPECT_EQ(groups.ofFace(1), Numbers{kHalf});
  EXPECT_EQ(groups.ofFace(2), Numbers{kHalf});
  EXPECT_EQ(groups.ofFace(3), Numbers{kAll});
}

TEST(MshGroups, ByNamesOfFacesOthersAreTheirOwn) {
  const ModelMesh mesh = groupedCube();
  const std::vector<Grouping> order{Grouping::Faces};
  const MshGroups groups(mesh, {{}, order}, {});
  EXPECT_EQ(groups.ofFace(3), Numbers{2});
  EXPECT_EQ(groups.ofFace(5), Numbers{5});
  EXPECT_EQ(groups.names().size(), 5u);
}

/// How often a line of the text begins with these words.
std::size_t linesWith(const std::string& text, const std::string& words) {
  std::size_t count = 0;
  for (std::size_t at = text.find(words); at != std::string::npos; at = text.find(words, at + 1))
    if (at == 0 || text[at - 1] == '\n') ++count;
  return count;
}

TEST(MshGroups, AreSolidsOfTextStlFiles) {
  const std::vector<Grouping> order{Grouping::Colors, Grouping::Parts};
  const std::string text = written(groupedCube(), ".stl", {LinesAlong::Boundaries, order});
  EXPECT_EQ(linesWith(text, "solid half\n"), 1u);
  EXPECT_EQ(linesWith(text, "solid all\n"), 1u);
  EXPECT_EQ(linesWith(text, "solid color #ff0000\n"), 1u);
  EXPECT_EQ(linesWith(text, "endsolid "), 3u);
  EXPECT_EQ(linesWith(text, "facet normal "), 12u);
}

TEST(MshGroups, AreGroupsOfObjFiles) {
  const std::vector<Grouping> names{Grouping::Faces};
  const std::string named =
      testing::written(groupedCube(), ".obj", {LinesAlong::Boundaries, names});
  EXPECT_EQ(linesWith(named, "g wall\n"), 2u) << "for each face in turn";
  EXPECT_EQ(linesWith(named, "g face_1\n"), 1u);
  const std::vector<Grouping> order{Grouping::Colors, Grouping::Parts};
  const std::string groups =
      testing::written(groupedCube(), ".obj", {LinesAlong::Boundaries, order});
  EXPECT_EQ(linesWith(groups, "g color_#ff0000\n"), 1u);
  EXPECT_EQ(linesWith(groups, "g face_"), 0u);
  EXPECT_EQ(linesWith(testing::written(groupedCube(), ".obj"), "g face_"), 6u);
}

TEST(MshGroups, NamesOfFacesAreFieldsOfVtuFiles) {
  const std::string text = written(groupedCube(), ".vtu", {});
  EXPECT_NE(text.find("Name=\"face: wall\" NumberOfTuples=\"2\" format=\"ascii\">2 3<"),
            std::string::npos);
}

TEST(MshGroups, NamesThatNoFaceUsesAreFreeForVolumes) {
  const ModelMesh mesh = groupedCube();
  const std::vector<Grouping> order{Grouping::Faces};
  const MshGroups groups(mesh, {{}, order}, {{1, "all", {1, 2, 3, 4, 5, 6}}});
  EXPECT_EQ(groups.names().at({PhysicalGroup::kVolume, 1}), "all");
}

TEST(MshGroups, Msh2HasEachElementOnce) {
  const std::string text = testing::written(groupedCube(), ".msh2");
  EXPECT_EQ(
      text.substr(0, text.find("$Nodes")),
      "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n5\n2 1 \"face 1\"\n2 2 \"wall\"\n"
      "2 4 \"face 4\"\n2 5 \"face 5\"\n2 6 \"lid\"\n$EndPhysicalNames\n");
  EXPECT_NE(text.find("$Elements\n11\n1 2 2 1 1 "), std::string::npos);
  EXPECT_NE(text.find("\n5 2 2 2 3 "), std::string::npos);   // a triangle of face 3
  EXPECT_NE(text.find("\n11 3 2 6 6 "), std::string::npos);  // the quadrilateral
}

}  // namespace
}  // namespace af2::geometry
