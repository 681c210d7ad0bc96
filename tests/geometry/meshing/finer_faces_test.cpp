// Faces that fail with the sizes that are asked for, and can be meshed with smaller ones.
#include "geometry/meshing/finer_faces.h"

#include <gtest/gtest.h>

#include <map>
#include <stop_token>
#include <vector>

#include "engine/base/error.h"
#include "geometry/meshing/face_crew.h"
#include "geometry/meshing/mesh_faces.h"
#include "tests/geometry/meshing/squares.h"
#include "tests/support/model_mesh.h"
#include "tests/support/triangle_rules.h"

namespace af2::geometry {
namespace {

/// Some of the squares fail with sizes above their limit.
class FailingSquares final : public testing::Squares {
 public:
  explicit FailingSquares(std::map<int, double> limits) : Squares(3), limits_(std::move(limits)) {}

  void fill(int face, const FillRequest& request, FaceMesh& mesh) const override {
    if (prepared.size() == stopIn) stop.request_stop();
    const auto limit = limits_.find(face);
    if (limit != limits_.end() && wantedOnFace(prepared.back().sizes, face) > limit->second)
      throw GeometryError("too coarse");
    Squares::fill(face, request, mesh);
  }
  void complete(const MeshFaults& faults, ModelMesh& mesh) const override {
    Squares::complete(faults, mesh);
    for (FaceReport& face : mesh.faces)
      if (face.status == FaceStatus::Failed) face.cause = cause;
  }
  double workOn(int) const override { return work; }

  FailureCause cause = FailureCause::Unknown;
  double work = 3;
  std::size_t stopIn = 0;  ///< in which of the meshes that are made
  mutable std::stop_source stop;

 private:
  std::map<int, double> limits_;
};

class FinerFaces : public ::testing::Test {
 protected:
  FinerFaces() { options.sizes.size = 1; }
  ModelMesh mesh(FaceSource& source) const {
    return meshFaces(source, AF2Algorithm(testing::triangleSet()), options);
  }
  void expectNotTried(FailingSquares& squares) const {
    const ModelMesh result = mesh(squares);
    EXPECT_EQ(squares.prepared.size(), 1u);
    EXPECT_EQ(failedFaces(result), 1u);
    EXPECT_EQ(result.notes.size(), 1u);
  }

  MeshingOptions options;
};

TEST_F(FinerFaces, HaveTheLargestSizesThatWork) {
  FailingSquares squares({{1, 0.6}, {3, 0.2}});
  const ModelMesh result = mesh(squares);
  testing::expectComplete(result, 3);
  EXPECT_EQ(squares.prepared.back().sizes.faceSizes, (std::map<int, double>{{1, 0.5}, {3, 0.125}}));
  ASSERT_EQ(result.notes.size(), 2u);
  EXPECT_EQ(
      result.notes[1],
      "could not be meshed with the size that was asked for: face 1 has 0.5, face 3 has 0.125");
}

TEST_F(FinerFaces, AreTriedAloneFirst) {
  FailingSquares squares({{2, 0.3}});
  mesh(squares);
  std::vector<std::vector<int>> asked;
  for (const MeshingOptions& prepared : squares.prepared) asked.push_back(prepared.faces);
  EXPECT_EQ(asked, (std::vector<std::vector<int>>{{}, {2}, {2}, {}}));
}

/// Those that mesh faces for the leader of a crew.
TEST_F(FinerFaces, AreKnownToOtherProcesses) {
  MeshingOptions changed = options;
  changed.faces = {2};
  changed.sizes.faceSizes = {{2, 0.25}};
  const MeshingOptions known = withChange(options, changeOf(changed));
  EXPECT_EQ(known.faces, changed.faces);
  EXPECT_EQ(known.sizes.faceSizes, changed.sizes.faceSizes);
}

TEST_F(FinerFaces, KeepTheirOwnSizesAsTheWhole) {
  FailingSquares squares({{2, 0.05}});
  options.sizes.faceSizes = {{2, 0.09}};
  mesh(squares);
  EXPECT_EQ(squares.prepared.back().sizes.faceSizes, (std::map<int, double>{{2, 0.045}}));
}

TEST_F(FinerFaces, StayFailedIfNoSizeHelps) {
  FailingSquares squares({{2, 0.01}});
  const ModelMesh result = mesh(squares);
  EXPECT_EQ(squares.prepared.size(), 3u);
  EXPECT_EQ(failedFaces(result), 1u);
  EXPECT_EQ(result.faces[1].reason, "too coarse");
  EXPECT_EQ(result.notes.size(), 1u);
}

/// The first mesh has more than one that is not finished.
TEST_F(FinerFaces, LeaveTheFirstMeshIfTheRunIsStopped) {
  for (const std::size_t stopIn : {2u, 3u, 4u}) {
    FailingSquares squares({{2, 0.3}});
    squares.stopIn = stopIn;
    options.stop = squares.stop.get_token();
    const ModelMesh result = mesh(squares);
    EXPECT_EQ(squares.prepared.size(), stopIn);
    EXPECT_EQ(failedFaces(result), 1u);
    EXPECT_EQ(result.elements.size(), 4u);
  }
}

TEST_F(FinerFaces, AreNotTriedBelowTheSmallestSize) {
  options.sizes.minSize = 0.3;
  FailingSquares squares({{2, 0.3}});
  expectNotTried(squares);
}

TEST_F(FinerFaces, AreNotTriedIfTheCauseIsKnown) {
  for (const FailureCause cause : {FailureCause::Model, FailureCause::Size}) {
    FailingSquares squares({{2, 0.3}});
    squares.cause = cause;
    expectNotTried(squares);
  }
}

TEST_F(FinerFaces, AreNotTriedIfTheyAreFineAlready) {
  FailingSquares squares({{2, 0.3}});
  squares.work = 1000;
  expectNotTried(squares);
}

TEST_F(FinerFaces, AreNotTriedWithFewRetries) {
  for (const int retries : {0, 1}) {
    FailingSquares squares({{2, 0.3}});
    options.mostRetries = retries;
    expectNotTried(squares);
  }
  FailingSquares squares({{2, 0.3}});
  options.mostRetries = {};
  options.strictRules = true;
  expectNotTried(squares);
}

}  // namespace
}  // namespace af2::geometry
