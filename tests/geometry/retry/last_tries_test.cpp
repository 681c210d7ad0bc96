#include "geometry/retry/last_tries.h"

#include <gtest/gtest.h>

#include "tests/geometry/retry/retried_faces.h"

namespace af2::geometry {
namespace {

FaceMesh meshed(std::size_t face, const TryLimits& limits) {
  FaceMesh mesh = limits.ignoresNormals ? testing::goodFace(static_cast<int>(face) + 1)
                                        : testing::failedFace(static_cast<int>(face) + 1);
  mesh.boundary = {0, 1, 2};
  mesh.wantedSizes = {1, 1, 1};
  return mesh;
}

FaceMeshes twoFailedFaces() {
  FaceMeshes state;
  state.divided.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  state.meshes = {testing::failedFace(1), testing::failedFace(2)};
  return state;
}

TEST(RefusingReflex, IsForFacesThatFailedWithRulesThatMakeReflexCorners) {
  bool hasRefused = false;
  const testing::RetriedFaces model({{1}, {2}}, [&](std::size_t i, const TryLimits& limits) {
    hasRefused = limits.refusesReflex && limits.failedBefore && !limits.ignoresNormals;
    FaceMesh mesh = testing::goodFace(static_cast<int>(i) + 1);
    mesh.boundary = {0, 1, 2};
    mesh.wantedSizes = {1, 1, 1};
    return mesh;
  });
  testing::RetrialOf of(model);
  FaceMeshes state = twoFailedFaces();
  EXPECT_FALSE(mayRefuseReflex(of.retrial, state, 0));
  of.options.mayMakeReflex = true;
  EXPECT_TRUE(mayRefuseReflex(of.retrial, state, 0));
  EXPECT_TRUE(meshWithoutReflex(of.retrial, state, 0));
  EXPECT_TRUE(hasRefused);
  EXPECT_FALSE(failed(state.meshes[0]));
  EXPECT_FALSE(mayRefuseReflex(of.retrial, state, 0));
}

TEST(IgnoringNormals, IsForFacesThatFailed) {
  const testing::RetriedFaces model({{1}, {2}}, meshed);
  testing::RetrialOf of(model);
  FaceMeshes state = twoFailedFaces();
  state.meshes[1] = testing::goodFace(2);
  EXPECT_TRUE(mayIgnoreNormals(of.retrial, state, 0));
  EXPECT_FALSE(mayIgnoreNormals(of.retrial, state, 1));
  of.options.mayTilt = false;
  EXPECT_FALSE(mayIgnoreNormals(of.retrial, state, 0));
}

TEST(IgnoringNormals, MeshesAFaceAndPutsTheFailedOneBackIfAsked) {
  const testing::RetriedFaces model({{1}, {2}}, meshed);
  testing::RetrialOf of(model);
  FaceMeshes state = twoFailedFaces();
  ASSERT_TRUE(meshIgnoringNormals(of.retrial, state, 0));
  EXPECT_FALSE(failed(state.meshes[0]));
  ASSERT_EQ(state.meshes[0].history.size(), 1u);
  EXPECT_EQ(textOf(state.meshes[0].history[0]), "it failed");
  restoreFailedFace(of.retrial, state, state, 0);
  EXPECT_TRUE(failed(state.meshes[0]));
}

TEST(IgnoringNormals, SharesTheBudgetAmongTheFacesThatAreLeft) {
  std::vector<std::size_t> allowed;
  const testing::RetriedFaces model({{1}, {2}}, [&](std::size_t i, const TryLimits& limits) {
    allowed.push_back(limits.maxCandidates);
    return testing::failedFace(static_cast<int>(i) + 1);
  });
  testing::RetrialOf of(model);
  of.retrial.budget = RetryBudget(1'000'000);
  FaceMeshes state = twoFailedFaces();
  EXPECT_FALSE(meshIgnoringNormals(of.retrial, state, 0));
  EXPECT_FALSE(meshIgnoringNormals(of.retrial, state, 1));
  EXPECT_EQ(allowed, (std::vector<std::size_t>{500'000, 998'000}));
}

TEST(IgnoringNormals, IsNotTriedOnceTheBudgetIsSpent) {
  const testing::RetriedFaces model({{1}, {2}}, meshed);
  testing::RetrialOf of(model);
  of.retrial.budget = RetryBudget(0);
  FaceMeshes state = twoFailedFaces();
  EXPECT_FALSE(meshIgnoringNormals(of.retrial, state, 0));
  EXPECT_FALSE(of.retrial.hasBudgetLeft);
  EXPECT_TRUE(failed(state.meshes[0]));
}

}  // namespace
}  // namespace af2::geometry
