#include "geometry/check/sound_faces.h"

#include <gtest/gtest.h>

#include "tests/support/small_meshes.h"

namespace af2::geometry {
namespace {

/// The cube with all its edges told as model edges.
ModelMesh closedCube() {
  ModelMesh mesh = cubeMesh();
  mesh.segments.clear();
  for (std::size_t i = 0; i < 4; ++i) {
    const std::size_t next = (i + 1) % 4;
    mesh.segments.push_back({VertexId(i), VertexId(next), 1, 2});
    mesh.segments.push_back({VertexId(4 + i), VertexId(4 + next), 2, 2});
    mesh.segments.push_back({VertexId(i), VertexId(4 + i), 3, 2});
  }
  return mesh;
}

TEST(KeepSoundFaces, LeavesASoundMeshAlone) {
  ModelMesh mesh = closedCube();
  EXPECT_TRUE(keepSoundFaces(mesh, faultsOf(mesh, false, 1)).empty());
  EXPECT_EQ(mesh.elements, closedCube().elements);
  EXPECT_EQ(mesh.vertices, closedCube().vertices);
}

TEST(KeepSoundFaces, TakesOutAFaceThatDoesNotPassAndSaysWhy) {
  ModelMesh mesh = closedCube();
  std::swap(mesh.elements[0].corners[0], mesh.elements[0].corners[1]);  // face 1, turned over
  EXPECT_TRUE(keepSoundFaces(mesh, faultsOf(mesh, false, 1)).empty());
  EXPECT_EQ(mesh.faces[0].status, FaceStatus::Failed);
  EXPECT_NE(mesh.faces[0].reason.find("does not pass its checks"), std::string::npos);
  EXPECT_EQ(mesh.elements.size(), 9u);
  EXPECT_EQ(mesh.face.size(), 9u);
  EXPECT_EQ(mesh.origins.size(), 9u);
  EXPECT_EQ(mesh.faces[1].status, FaceStatus::Complete);
}

TEST(KeepSoundFaces, TellsOfABoundaryThatTheMeshLacks) {
  ModelMesh mesh = closedCube();
  mesh.segments.push_back({VertexId(0), VertexId(6), 4, 1});
  EXPECT_EQ(keepSoundFaces(mesh, faultsOf(mesh, false, 1)).size(), 1u);
}

TEST(KeepSoundFaces, FailsAllFacesIfThereAreNoElements) {
  ModelMesh mesh = closedCube();
  dropElements(mesh, {1, 2, 3, 4, 5, 6});
  keepSoundFaces(mesh, {});
  for (const FaceReport& face : mesh.faces) {
    EXPECT_EQ(face.status, FaceStatus::Failed);
    EXPECT_NE(face.reason.find("smaller"), std::string::npos);
    EXPECT_EQ(face.cause, FailureCause::Size);
  }
}

TEST(DropElements, RemovesVerticesAndSegmentsThatNothingUsesAnyMore) {
  ModelMesh mesh = closedCube();
  dropElements(mesh, {2, 3, 4, 5, 6});
  EXPECT_EQ(mesh.vertices.size(), 4u);
  EXPECT_EQ(mesh.elements.size(), 2u);
  EXPECT_EQ(mesh.segments.size(), 4u);
  for (const Element& element : mesh.elements) {
    for (const VertexId vertex : element.vertices()) EXPECT_LT(vertex.value, 4u);
  }
}

}  // namespace
}  // namespace af2::geometry
