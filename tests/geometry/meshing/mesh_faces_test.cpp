#include "geometry/meshing/mesh_faces.h"

#include <gtest/gtest.h>

#include <new>
#include <string>
#include <vector>

#include "engine/base/error.h"
#include "tests/geometry/meshing/squares.h"
#include "tests/support/model_mesh.h"
#include "tests/support/triangle_rules.h"

namespace af2::geometry {
namespace {

using testing::Squares;

class MeshFaces : public ::testing::Test {
 protected:
  MeshFaces() { options.sizes.size = 1; }
  ModelMesh mesh(FaceSource& source) const { return meshFaces(source, algorithm, options); }

  AF2Algorithm algorithm{testing::triangleSet()};
  MeshingOptions options;
};

TEST_F(MeshFaces, JoinsFacesAtTheirEdges) {
  Squares squares(3);
  const ModelMesh result = mesh(squares);
  testing::expectComplete(result, 3);
  EXPECT_EQ(result.vertices.size(), 8u);
  EXPECT_EQ(result.faces[2].name, "square 3");
  EXPECT_EQ(result.groups.size(), 3u);
  EXPECT_EQ(result.notes, std::vector<std::string>{"these are squares"});
  EXPECT_EQ(result.ruleNames[result.ruleNames.size() - 2], "closing");
  EXPECT_EQ(result.ruleNames.back(), "fan");
  for (const EdgeSegment& segment : result.segments)
    EXPECT_EQ(segment.uses, segment.edge == 104 || segment.edge == 107 ? 2 : 1) << segment.edge;
}

TEST_F(MeshFaces, MeshesThoseAskedForInTheirOrder) {
  Squares squares(5);
  options.faces = {4, 2, 4};
  const ModelMesh result = mesh(squares);
  testing::expectComplete(result, 2);
  EXPECT_EQ(squares.asked, (std::vector<int>{2, 4}));
  EXPECT_EQ(result.face, (std::vector<std::int32_t>{2, 2, 4, 4}));
}

TEST_F(MeshFaces, RefuseWhatTheModelDoesNotHave) {
  Squares squares(3);
  const auto faultOf = [&](auto&& change) -> std::string {
    options = {};
    options.sizes.size = 1;
    change(options);
    try {
      mesh(squares);
    } catch (const InputError& error) {
      return error.what();
    }
    return "no fault";
  };
  EXPECT_EQ(faultOf([](MeshingOptions& o) { o.sizes.size = 0; }),
            "the size must be a positive number");
  EXPECT_EQ(faultOf([](MeshingOptions& o) { o.sizes.faceSizes[4] = 1; }),
            "size for face 4: the model has faces 1 to 3");
  EXPECT_EQ(faultOf([](MeshingOptions& o) { o.sizes.edgeSizes[2] = -1; }),
            "size for edge 2: must be positive");
  EXPECT_EQ(faultOf([](MeshingOptions& o) { o.edgePoints[111] = {}; }),
            "points for edge 111: the model has edges 1 to 110");
  EXPECT_EQ(faultOf([](MeshingOptions& o) { o.faces = {0}; }),
            "face 0: the model has faces 1 to 3");
  EXPECT_EQ(faultOf([](MeshingOptions& o) { o.order = 3; }), "elements can have order 1 or 2");
  EXPECT_EQ(faultOf([](MeshingOptions& o) {
              o.sizes.partSizes = {{"circle*", 1}};
            }),
            "the sizes are for parts named 'circle*', but no face or group has such a name (see "
            "af2 inspect)");
  EXPECT_TRUE(squares.prepared.empty());
}

TEST_F(MeshFaces, SizesByNameAreSizesByFaceAndNoneIsLargerThanTheModel) {
  Squares squares(3);
  options.sizes.size = 1e9;
  options.sizes.partSizes = {{"square *", 0.5}, {"group 2", 0.25}};
  options.sizes.faceSizes = {{3, 0.125}};
  mesh(squares);
  const Sizes& sizes = squares.prepared.at(0).sizes;
  EXPECT_EQ(sizes.faceSizes, (std::map<int, double>{{1, 0.5}, {2, 0.25}, {3, 0.125}}));
  EXPECT_TRUE(sizes.partSizes.empty());
  EXPECT_EQ(sizes.size, squares.diagonal());
  EXPECT_EQ(sizes.maxSize, squares.diagonal());
}

TEST_F(MeshFaces, WhatIsThrownForAFaceFailsItAlone) {
  struct Throwing : Squares {
    using Squares::Squares;
    void fill(int face, const FillRequest& request, FaceMesh& mesh) const override {
      if (face == 1) throw GeometryError("no surface");
      if (face == 2) throw std::bad_alloc();
      if (face == 3) throw InternalError("broken");
      Squares::fill(face, request, mesh);
    }
  } squares(4);
  const ModelMesh result = mesh(squares);
  ASSERT_EQ(result.faces.size(), 4u);
  EXPECT_EQ(result.faces[0].reason, "no surface");
  EXPECT_EQ(result.faces[1].reason, "there is not enough memory; ask for a larger size");
  EXPECT_EQ(result.faces[2].reason, "broken");
  for (const std::size_t i : {0, 1, 2}) EXPECT_EQ(result.faces[i].status, FaceStatus::Failed);
  EXPECT_EQ(result.faces[3].status, FaceStatus::Complete);
  EXPECT_DOUBLE_EQ(testing::areaOf(result), 1);
}

TEST_F(MeshFaces, WhatFailedIsTriedAgain) {
  struct Stubborn : Squares {
    using Squares::Squares;
    void fill(int face, const FillRequest& request, FaceMesh& mesh) const override {
      if (face == 2 && request.limits.hasOriginalSizes) {
        mesh.diagnosis.isBad = true;
        mesh.diagnosis.places = {{{1.5, 0.5, 0}, 0.1}};
        mesh.searchCost = 1000;
        throw GeometryError("no room");
      }
      if (face == 2) wanted = request.sizes.at(Point3{1.5, 0.5, 0});
      Squares::fill(face, request, mesh);
    }
    mutable double wanted = 0;
  } squares(3);
  const ModelMesh result = mesh(squares);
  testing::expectComplete(result, 3);
  EXPECT_DOUBLE_EQ(squares.wanted, 0.1);
  EXPECT_EQ(result.faces[1].attempts.at(0), "no room");
}

TEST_F(MeshFaces, OnRequestWhatFailedIsLeft) {
  struct Failing : Squares {
    using Squares::Squares;
    void fill(int, const FillRequest&, FaceMesh& mesh) const override {
      ++tries;
      mesh.diagnosis.isBad = true;
      mesh.diagnosis.places = {{{}, 0.1}};
      throw GeometryError("no room");
    }
    mutable int tries = 0;
  } often(1), once(1);
  mesh(often);
  options.mostRetries = 0;
  mesh(once);
  EXPECT_LT(once.tries, often.tries);
}

TEST_F(MeshFaces, EachFaceHasItsObserver) {
  Squares squares(3);
  options.threads = 1;
  std::vector<int> observed;
  options.observer = [&](int face) {
    observed.push_back(face);
    return nullptr;
  };
  mesh(squares);
  EXPECT_EQ(observed, (std::vector<int>{1, 2, 3}));
}

TEST_F(MeshFaces, TheirProgressAddsUp) {
  Squares squares(3);
  ModelProgress last;
  options.progress = [&](const ModelProgress& progress) {
    EXPECT_GE(progress.workDone, last.workDone);
    last = progress;
  };
  mesh(squares);
  EXPECT_EQ(last.facesDone, 3);
  EXPECT_EQ(last.faces, 3);
  EXPECT_EQ(last.elements, 6u);
  EXPECT_DOUBLE_EQ(last.workDone, 9);
  EXPECT_DOUBLE_EQ(last.workTotal, 9);
}

TEST_F(MeshFaces, AreCancelledWithTheRun) {
  Squares squares(2);
  std::stop_source source;
  source.request_stop();
  options.stop = source.get_token();
  for (const FaceReport& face : mesh(squares).faces) EXPECT_EQ(face.status, FaceStatus::Cancelled);
}

TEST_F(MeshFaces, OfSecondOrderHaveMiddlesOnTheEdges) {
  Squares squares(1);
  options.order = 2;
  const ModelMesh result = mesh(squares);
  EXPECT_EQ(result.midsides.size(), 2u);
  for (const EdgeSegment& segment : result.segments)
    EXPECT_EQ(segment.middle, squares.pointOnEdge(segment.edge - 100, 0.5));
}

TEST_F(MeshFaces, SizesOfEdgesHoldAtTheirVertices) {
  Squares squares(2);
  options.sizes.edgeSizes[101] = 0.25;  // at x = 0
  const ModelMesh result = mesh(squares);
  for (std::size_t v = 0; v < result.vertices.size(); ++v)
    EXPECT_EQ(result.wantedSizes[v], result.vertices[v].x == 0 ? 0.25 : 1);
}

TEST_F(MeshFaces, AFirstMeshOfAllShowsWhatIsNarrow) {
  Squares squares(3);
  options.faces = {2};
  options.order = 2;
  options.sizes.elementsAcross = 4;
  const ModelMesh result = mesh(squares);
  ASSERT_EQ(squares.prepared.size(), 2u);
  const MeshingOptions &first = squares.prepared[0], &second = squares.prepared[1];
  EXPECT_TRUE(first.faces.empty());
  EXPECT_FALSE(first.optimize);
  EXPECT_EQ(first.order, 1);
  EXPECT_TRUE(first.sizes.sources.isEmpty());
  EXPECT_EQ(squares.asked, std::vector<int>{2});
  ASSERT_FALSE(second.sizes.sources.isEmpty());
  EXPECT_DOUBLE_EQ(second.sizes.sources.points[0].size, 0.25);
  EXPECT_EQ(second.order, 2);
  EXPECT_EQ(second.sizes.elementsAcross, 0);
}

}  // namespace
}  // namespace af2::geometry
