#include "geometry/meshing/congruent_faces.h"

#include <gtest/gtest.h>

#include "tests/geometry/meshing/squares.h"
#include "tests/support/triangle_rules.h"

namespace af2::geometry {
namespace {

FaceMesh meshOf(int face, int congruentTo, std::size_t searchCost) {
  FaceMesh mesh;
  mesh.report.id = face;
  mesh.report.congruentTo = congruentTo;
  mesh.searchCost = searchCost;
  return mesh;
}

TEST(CongruentFacesOfARun, DoNotReferToFormerMeshes) {
  std::vector<FaceMesh> meshes = {meshOf(4, 0, 10), meshOf(5, 4, 10), meshOf(6, 4, 11),
                                  meshOf(7, 5, 10)};
  forgetFormerMeshes(meshes);
  EXPECT_EQ(meshes[1].report.congruentTo, 4);
  EXPECT_EQ(meshes[2].report.congruentTo, 0);
  EXPECT_EQ(meshes[3].report.congruentTo, 0);
}

TEST(CongruentFacesOfARun, MustBeAllowedAsMuch) {
  TryLimits one, other;
  EXPECT_TRUE(other.allow(one, 1000));
  other.maxCandidates = 999;
  EXPECT_FALSE(other.allow(one, 1000));
  EXPECT_TRUE(other.allow(one, 999));
  for (bool TryLimits::*flag :
       {&TryLimits::ignoresNormals, &TryLimits::refusesReflex, &TryLimits::failedBefore}) {
    other = {};
    other.*flag = true;
    EXPECT_FALSE(other.allow(one, 0));
    EXPECT_FALSE(one.allow(other, 0));
  }
}

/// A model whose faces can be compared.
class ComparableSquares final : public testing::Squares {
 public:
  using Squares::Squares;
  bool hasOutlines() const override { return true; }
};

TEST(CongruentFacesOfARun, AreComparedWithAFewMeshesOnly) {
  const ComparableSquares source(50);
  std::vector<int> faces;
  std::vector<std::size_t> meshed;
  for (int face = 1; face <= 50; ++face) faces.push_back(face);
  for (std::size_t i = 1; i < 50; ++i) meshed.push_back(i);
  const MeshingOptions options;
  const AF2Algorithm algorithm(testing::triangleSet());
  const std::vector<FaceTry> tries = {{0, {}}};
  const auto groups = CongruentFaces(source, algorithm, options, faces)
                          .groupsOf(tries, meshed, source.divide({}, {}, {}));
  ASSERT_EQ(groups.size(), 1u);
  EXPECT_GE(groups[0].meshed.size(), 1u);
  EXPECT_LE(groups[0].meshed.size(), 5u);
}

TEST(CongruentFacesOfARun, AreInGroupsOnlyIfTheSourceKnowsOutlines) {
  const testing::Squares source(3);
  const ComparableSquares withOutlines(3);
  const MeshingOptions options;
  const std::vector<int> faces = {1, 2, 3};
  const std::vector<FaceTry> tries = {{0, {}}, {2, {}}};
  const AF2Algorithm algorithm(testing::triangleSet());
  const DividedEdges divided = source.divide({}, {}, {});
  const std::vector<std::size_t> meshed = {1};
  EXPECT_EQ(
      CongruentFaces(source, algorithm, options, faces).groupsOf(tries, meshed, divided).size(),
      2u);
  const auto groups =
      CongruentFaces(withOutlines, algorithm, options, faces).groupsOf(tries, meshed, divided);
  ASSERT_EQ(groups.size(), 1u);
  EXPECT_EQ(groups[0].tries.size(), 2u);
  EXPECT_EQ(groups[0].meshed, meshed);
}

}  // namespace
}  // namespace af2::geometry
