#include "geometry/retry/withdrawn_requests.h"

#include <gtest/gtest.h>

#include "tests/geometry/retry/retried_faces.h"

namespace af2::geometry {
namespace {

TEST(WithdrawnRequests, AreThoseOfFacesThatHaveFailedAllTheSame) {
  const testing::RetriedFaces model({{1}, {2}, {3}});
  testing::RetrialOf of(model);
  for (const std::size_t face : {0u, 1u}) of.retrial.requests.add(face, {{{0, 0, 0}, 0.1}});
  FaceMeshes state;
  state.meshes = {testing::failedFace(1), testing::goodFace(2), testing::failedFace(3)};
  EXPECT_TRUE(hasVainRequests(of.retrial, state, 0));
  EXPECT_FALSE(hasVainRequests(of.retrial, state, 1)) << "they have helped";
  EXPECT_FALSE(hasVainRequests(of.retrial, state, 2)) << "there are none";
  withdrawRequests(of.retrial, state, 0);
  EXPECT_FALSE(of.retrial.requests.hasAny(0));
  EXPECT_TRUE(of.retrial.requests.hasAny(1));
}

TEST(WithdrawnRequests, AreCollapsedEdgesToo) {
  const testing::RetriedFaces model(testing::Edges{{1}});
  testing::RetrialOf of(model);
  of.retrial.requests.collapse(0, {{1, 0.1}});
  FaceMeshes state;
  state.meshes = {testing::failedFace(1)};
  ASSERT_TRUE(hasVainRequests(of.retrial, state, 0));
  withdrawRequests(of.retrial, state, 0);
  EXPECT_TRUE(of.retrial.requests.collapsedEdges().empty());
}

}  // namespace
}  // namespace af2::geometry
