#include "geometry/retry/score.h"

#include <gtest/gtest.h>

#include "tests/geometry/retry/retried_faces.h"

namespace af2::geometry {
namespace {

FaceMeshes stateOf(std::vector<FaceMesh> meshes) {
  FaceMeshes state;
  state.meshes = std::move(meshes);
  return state;
}

FaceMesh faceWith(double poorness, bool hasBadAngle, std::size_t elements) {
  FaceMesh mesh = testing::goodFace(1);
  mesh.diagnosis.poorness = poorness;
  mesh.diagnosis.hasBadAngle = hasBadAngle;
  mesh.elements.resize(elements);
  return mesh;
}

TEST(Score, CountsFailedFacesFirstThenBadAnglesThenPoornessThenElements) {
  const Score failed = scoreOf(stateOf({testing::failedFace(1)}));
  const Score sharp = scoreOf(stateOf({faceWith(0, true, 1)}));
  const Score poor = scoreOf(stateOf({faceWith(2, false, 1)}));
  const Score many = scoreOf(stateOf({faceWith(1, false, 9)}));
  const Score few = scoreOf(stateOf({faceWith(1, false, 5)}));
  EXPECT_LT(few, many);
  EXPECT_LT(many, poor);
  EXPECT_LT(poor, sharp);
  EXPECT_LT(sharp, failed);
}

TEST(Score, CountsOneOfTwoFacesThatCrossAsFailed) {
  FaceMeshes state = stateOf({testing::goodFace(1), testing::goodFace(2)});
  state.faults.crossings.push_back({{ElementId(0), ElementId(1)}, {1, 2}, false, {}});
  EXPECT_EQ(scoreOf(state).failedFaces, 1u);
  EXPECT_EQ(crossingsAt(state, 0), 1);
  EXPECT_EQ(crossingsAt(state, 1), 1);
}

}  // namespace
}  // namespace af2::geometry
