#include "geometry/retry/collapsed_edges.h"

#include <gtest/gtest.h>

#include "tests/geometry/retry/retried_faces.h"

namespace af2::geometry {
namespace {

const CollapsedEdges kVeryShort{{3, 0.01}}, kShort{{3, 0.1}, {4, 0.1}};

testing::RetriedFaces modelWithShortEdges() {
  testing::RetriedFaces model(testing::Edges{{3, 4}});
  model.choices = {kVeryShort, kShort};
  return model;
}

TEST(CollapsedEdges, AreTriedAtOnceIfNobodyKnowsWhereEdgesShouldBeShorter) {
  const testing::RetriedFaces model = modelWithShortEdges();
  testing::RetrialOf of(model);
  FaceMeshes state;
  state.meshes = {testing::failedFace(1)};
  findShortEdges(of.retrial, state, 0);
  EXPECT_TRUE(mayCollapseEdges(of.retrial, state, 0));
}

TEST(CollapsedEdges, WaitUntilShorterEdgesHaveFailedTwice) {
  const testing::RetriedFaces model = modelWithShortEdges();
  testing::RetrialOf of(model);
  FaceMeshes state;
  state.meshes = {testing::failedFace(1, {{{0, 0, 0}, 0.1}})};
  findShortEdges(of.retrial, state, 0);
  EXPECT_FALSE(mayCollapseEdges(of.retrial, state, 0));
  of.retrial.faces[0].failures = 2;
  EXPECT_TRUE(mayCollapseEdges(of.retrial, state, 0));
}

TEST(CollapsedEdges, TakeThePlaceOfWhatWasAskedForBeforeTheShortestFirst) {
  const testing::RetriedFaces model = modelWithShortEdges();
  testing::RetrialOf of(model);
  FaceMeshes state;
  state.meshes = {testing::failedFace(1)};
  findShortEdges(of.retrial, state, 0);
  of.retrial.requests.add(0, {{{0, 0, 0}, 0.1}});
  EXPECT_EQ(collapseEdges(of.retrial, state, 0), 1u);
  EXPECT_FALSE(of.retrial.requests.has(0));
  EXPECT_EQ(of.retrial.requests.collapsedEdges(), kVeryShort);
  EXPECT_EQ(collapseEdges(of.retrial, state, 0), 2u);
  EXPECT_EQ(of.retrial.requests.collapsedEdges(), kShort);
  EXPECT_FALSE(mayCollapseEdges(of.retrial, state, 0)) << "there is no other choice left";
  uncollapseEdges(of.retrial, state, state, 0);
  EXPECT_TRUE(of.retrial.requests.collapsedEdges().empty());
}

TEST(CollapsedEdges, AreNotLookedForOnAFaceThatIsComplete) {
  const testing::RetriedFaces model = modelWithShortEdges();
  testing::RetrialOf of(model);
  FaceMeshes state;
  state.meshes = {testing::goodFace(1)};
  findShortEdges(of.retrial, state, 0);
  EXPECT_FALSE(mayCollapseEdges(of.retrial, state, 0));
}

}  // namespace
}  // namespace af2::geometry
