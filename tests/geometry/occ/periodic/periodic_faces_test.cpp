// Faces whose meshes are images of each other.
#include "geometry/occ/periodic/periodic_faces.h"

#include <gtest/gtest.h>
#include <BRepAlgoAPI_Cut.hxx>
#include <BRepAlgoAPI_Fuse.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>

#include <cmath>
#include <map>
#include <numbers>
#include <set>

#include "engine/base/error.h"
#include "geometry/mesh/quality.h"
#include "geometry/occ/periodic/face_map.h"
#include "tests/geometry/occ/meshing.h"
#include "tests/support/model_mesh.h"
#include "tests/support/triangle_rules.h"

namespace af2::geometry {
namespace {

ModelMesh meshed(const Model& model, const PeriodicRequest& request, double size, int order = 1,
                 const std::optional<MergeRequest>& merge = {}) {
  const AF2Algorithm algorithm(testing::triangleSet());
  MeshingOptions options = testing::ofSize(size);
  options.order = order;
  ModelMesh mesh = meshPeriodic(model, algorithm, options, findPeriodic(model, request), merge);
  testing::expectComplete(mesh);
  EXPECT_TRUE(mesh.findings.empty());
  EXPECT_EQ(measureQuality(mesh).freeEdges, 0u);
  return mesh;
}

std::set<std::set<VertexId>> elementsOf(const ModelMesh& mesh, int face) {
  std::set<std::set<VertexId>> elements;
  for (std::size_t e = 0; e < mesh.elements.size(); ++e)
    if (mesh.face[e] == face) {
      const auto corners = mesh.elements[e].vertices();
      elements.insert({corners.begin(), corners.end()});
    }
  return elements;
}

/// Positions to 1e-12, and the same elements.
void expectImages(const ModelMesh& mesh, std::size_t pairs) {
  ASSERT_EQ(mesh.periodic.size(), pairs);
  for (const PeriodicPair& pair : mesh.periodic) {
    const FaceMap map(pair.transform);
    std::map<VertexId, VertexId> firstOf;
    for (const auto& [second, first] : pair.vertices) {
      EXPECT_LT(distance(map.at(mesh.vertices[first.value]), mesh.vertices[second.value]), 1e-12);
      firstOf[second] = first;
    }
    std::set<std::set<VertexId>> back;
    for (const std::set<VertexId>& element : elementsOf(mesh, pair.second)) {
      std::set<VertexId> corners;
      for (const VertexId v : element) corners.insert(firstOf.at(v));
      back.insert(corners);
    }
    EXPECT_FALSE(back.empty());
    EXPECT_EQ(back, elementsOf(mesh, pair.first));
  }
}

// Two boxes side by side, made one solid: the four sides along x have two faces each.
TEST(PeriodicFaces, MayBeBesideMergedOnes) {
  const Model model = testing::modelOf(
      BRepAlgoAPI_Fuse(BRepPrimAPI_MakeBox(gp_Pnt(0, 0, 0), gp_Pnt(5, 6, 4)).Shape(),
                       BRepPrimAPI_MakeBox(gp_Pnt(5, 0, 0), gp_Pnt(10, 6, 4)).Shape())
          .Shape());
  const ModelMesh along = meshed(model, {{"x"}, {}}, 0.9, 1, MergeRequest());
  expectImages(along, 1);
  EXPECT_EQ(along.merging->groups.size(), 4u);
  EXPECT_NEAR(testing::volumeOf(along), 240, 1e-9);
  const ModelMesh both = meshed(model, {{"x", "y"}, {}}, 0.9, 1, MergeRequest());
  expectImages(both, 3);
  EXPECT_EQ(both.merging->groups.size(), 2u);
}

TEST(PeriodicFaces, MatchInAllDirectionsOfACell) {
  const Model model =
      testing::modelOf(BRepAlgoAPI_Cut(BRepPrimAPI_MakeBox(10, 8, 6).Shape(),
                                       BRepPrimAPI_MakeSphere(gp_Pnt(0, 4, 3), 2).Shape())
                           .Shape());
  // The ball is cut out at one side only.
  EXPECT_THROW(findPeriodic(model, {{"x"}, {}}), InputError);
  expectImages(meshed(model, {{"y", "z"}, {}}, 1.3), 2);
}

TEST(PeriodicFaces, MatchAlsoWithHolesThroughThem) {
  const Model model = testing::modelOf(
      BRepAlgoAPI_Cut(BRepPrimAPI_MakeBox(10, 8, 6).Shape(),
                      BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(-1, 4, 3), gp::DX()), 1.5, 12).Shape())
          .Shape());
  expectImages(meshed(model, {{"x", "y", "z"}, {}}, 1.1), 3);
}

std::set<VertexId> midsidesOf(const ModelMesh& mesh, int face) {
  std::set<VertexId> midsides;
  for (std::size_t e = 0; e < mesh.elements.size(); ++e)
    if (mesh.face[e] == face)
      for (std::size_t i = 0; i < mesh.elements[e].vertices().size(); ++i)
        midsides.insert(mesh.midsides[e][i]);
  return midsides;
}

/// Where the hole ends, sides of elements are curved.
TEST(PeriodicFaces, MatchInSecondOrder) {
  const Model model = testing::modelOf(
      BRepAlgoAPI_Cut(BRepPrimAPI_MakeBox(10, 8, 6).Shape(),
                      BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(-1, 4, 3), gp::DX()), 1.5, 12).Shape())
          .Shape());
  const ModelMesh mesh = meshed(model, {{"x", "y", "z"}, {}}, 1.1, 2);
  expectImages(mesh, 3);
  EXPECT_TRUE(mesh.straightened.empty());
  std::size_t onCircle = 0;
  for (const PeriodicPair& pair : mesh.periodic) {
    std::set<VertexId> images, own;
    for (const auto& [second, first] : pair.vertices) {
      images.insert(second);
      own.insert(first);
    }
    for (const VertexId v : midsidesOf(mesh, pair.first)) EXPECT_TRUE(own.contains(v));
    for (const VertexId v : midsidesOf(mesh, pair.second)) {
      EXPECT_TRUE(images.contains(v));
      const Point3& p = mesh.vertices[v.value];
      onCircle += std::abs(p.x - 10) < 1e-12 && std::abs(std::hypot(p.y - 4, p.z - 3) - 1.5) < 1e-9;
    }
  }
  EXPECT_GE(onCircle, 8u);
}

TEST(PeriodicFaces, MatchByRotation) {
  const Model model =
      testing::modelOf(BRepPrimAPI_MakeCylinder(5, 10, std::numbers::pi / 3).Shape());
  std::vector<int> planes;
  for (int face = 1; face <= model.faceCount(); ++face)
    if (model.surfaceType(face) == "plane") planes.push_back(face);
  // The cuts are the two planes of the same area that are mapped by a rotation.
  int found = 0;
  for (const int first : planes)
    for (const int second : planes) {
      if (first >= second) continue;
      try {
        const ModelMesh mesh = meshed(model, {{}, {{first, second}}}, 1);
        expectImages(mesh, 1);
        if (std::abs(mesh.periodic[0].transform[0] - 0.5) < 1e-9) ++found;
      } catch (const InputError&) {
      }
    }
  EXPECT_EQ(found, 1);
}

TEST(PeriodicFaces, AreRefusedWithTheReason) {
  const Model model = testing::box(1, 2, 3);
  try {
    findPeriodic(model, {{}, {{1, 3}}});
    FAIL();
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("face 1 and face 3 are not periodic: their areas"),
              std::string::npos)
        << error.what();
  }
  EXPECT_THROW(findPeriodic(model, {{}, {{1, 1}}}), InputError);
  EXPECT_THROW(findPeriodic(model, {{}, {{1, 99}}}), InputError);
  EXPECT_THROW(findPeriodic(testing::sphere(1), {{"x"}, {}}), InputError);
}

TEST(PeriodicFaces, AreTheSameForAnyNumberOfThreads) {
  const Model model = testing::box(3, 2, 1);
  const AF2Algorithm algorithm(testing::triangleSet());
  MeshingOptions options = testing::ofSize(0.4);
  const auto pairs = findPeriodic(model, {{"x", "y"}, {}});
  const ModelMesh one = meshPeriodic(model, algorithm, options, pairs);
  options.threads = 3;
  const ModelMesh three = meshPeriodic(model, algorithm, options, pairs);
  EXPECT_EQ(one.vertices, three.vertices);
  EXPECT_EQ(one.elements, three.elements);
}

}  // namespace
}  // namespace af2::geometry
