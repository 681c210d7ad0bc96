#include "geometry/retry/shorter_edges.h"

#include <gtest/gtest.h>

#include "tests/geometry/retry/retried_faces.h"

namespace af2::geometry {
namespace {

const SizeSource kPlace{{1, 0, 0}, 0.1};

double sizeAtPlace(const Retrial& retrial) { return retrial.requests.sizes().at(kPlace.position); }

TEST(ShorterEdges, AreAskedForWhereAFaceIsAtFault) {
  const testing::RetriedFaces model(testing::Edges{{1}});
  testing::RetrialOf of(model);
  FaceMeshes state;
  state.meshes = {testing::failedFace(1, {kPlace})};
  ASSERT_TRUE(mayShortenEdges(of.retrial, state, 0));
  EXPECT_EQ(shortenEdges(of.retrial, state, 0), 1u);
  EXPECT_DOUBLE_EQ(sizeAtPlace(of.retrial), 0.1);
}

TEST(ShorterEdges, AreNotAskedForAtAFaceWithoutFault) {
  const testing::RetriedFaces model(testing::Edges{{1}});
  testing::RetrialOf of(model);
  FaceMeshes state;
  state.meshes = {testing::goodFace(1)};
  EXPECT_FALSE(mayShortenEdges(of.retrial, state, 0));
}

TEST(ShorterEdges, AreNotAskedForWhereTheModelIsAtFault) {
  testing::RetriedFaces model(testing::Edges{{1}});
  model.isFaulty = true;
  testing::RetrialOf of(model);
  FaceMeshes state;
  state.meshes = {testing::failedFace(1, {kPlace})};
  findFault(of.retrial, state, 0);
  EXPECT_FALSE(mayShortenEdges(of.retrial, state, 0));
  state.meshes = {testing::goodFace(1)};
  state.meshes[0].diagnosis.places = {kPlace};
  EXPECT_TRUE(mayShortenEdges(of.retrial, state, 0)) << "it has a mesh, which may become better";
}

TEST(ShorterEdges, AreAskedForOnceIfAMeshIsFitForUse) {
  const testing::RetriedFaces model(testing::Edges{{1}});
  testing::RetrialOf of(model);
  FaceMeshes state;
  state.meshes = {testing::goodFace(1)};
  state.meshes[0].diagnosis.places = {kPlace};
  ASSERT_TRUE(mayShortenEdges(of.retrial, state, 0));
  shortenEdges(of.retrial, state, 0);
  EXPECT_FALSE(mayShortenEdges(of.retrial, state, 0));
}

TEST(ShorterEdges, FollowTheSizesInsideOfAFaceThatFailedAnywhere) {
  testing::RetriedFaces model(testing::Edges{{1}});
  model.inside = {kPlace};
  testing::RetrialOf of(model);
  FaceMeshes state;
  state.meshes = {testing::failedFace(1)};
  ASSERT_TRUE(mayShortenEdges(of.retrial, state, 0));
  EXPECT_EQ(shortenEdges(of.retrial, state, 0), 0u) << "no place is at fault";
  EXPECT_DOUBLE_EQ(sizeAtPlace(of.retrial), 0.1);
}

TEST(ShorterEdges, AreTakenBackAltogetherWhereAFaceFailedBefore) {
  const testing::RetriedFaces model(testing::Edges{{1}});
  testing::RetrialOf of(model);
  FaceMeshes state;
  state.meshes = {testing::failedFace(1, {kPlace})};
  shortenEdges(of.retrial, state, 0);
  shortenEdges(of.retrial, state, 0);
  unshortenEdges(of.retrial, state, state, 0);
  EXPECT_FALSE(of.retrial.requests.hasAny(0));
}

TEST(ShorterEdges, AreTakenBackByOneRoundWhereAFaceIsMerelyNoBetter) {
  const testing::RetriedFaces model(testing::Edges{{1}});
  testing::RetrialOf of(model);
  FaceMeshes state;
  state.meshes = {testing::goodFace(1)};
  state.meshes[0].diagnosis.places = {kPlace};
  shortenEdges(of.retrial, state, 0);
  shortenEdges(of.retrial, state, 0);
  unshortenEdges(of.retrial, state, state, 0);
  EXPECT_TRUE(of.retrial.requests.has(0));
  unshortenEdges(of.retrial, state, state, 0);
  EXPECT_FALSE(of.retrial.requests.has(0));
}

TEST(ShorterEdges, AreNotAskedForOnceTheBudgetIsSpent) {
  const testing::RetriedFaces model(testing::Edges{{1}});
  testing::RetrialOf of(model);
  of.retrial.hasBudgetLeft = false;
  FaceMeshes state;
  state.meshes = {testing::failedFace(1, {kPlace})};
  EXPECT_FALSE(mayShortenEdges(of.retrial, state, 0));
}

}  // namespace
}  // namespace af2::geometry
