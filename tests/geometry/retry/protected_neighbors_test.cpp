#include "geometry/retry/protected_neighbors.h"

#include <gtest/gtest.h>

#include "tests/geometry/retry/retried_faces.h"

namespace af2::geometry {
namespace {

const SizeSource kWantedPlace{{1, 0, 0}, 0.1};

/// Faces 0 and 1 share edge 2, face 2 lies apart. Face 0 has asked for shorter edges.
class ProtectedNeighbors : public ::testing::Test {
 protected:
  ProtectedNeighbors() { of_.retrial.requests.add(0, {kWantedPlace}); }

  /// Face 1 was good and is bad now.
  void spoil(bool wasCulpritBad) {
    FaceMeshes before;
    before.meshes = {wasCulpritBad ? testing::failedFace(1) : testing::goodFace(1),
                     testing::goodFace(2), testing::goodFace(3)};
    for (std::size_t i = 0; i < 3; ++i) rememberBadFace(of_.retrial, before, i);
    next_.meshes = {testing::goodFace(1), testing::failedFace(2), testing::goodFace(3)};
  }
  double sizeAtPlace() const { return of_.retrial.requests.sizes().at(kWantedPlace.position); }

  const testing::RetriedFaces model_{{{1, 2}, {2, 3}, {4}}};
  testing::RetrialOf of_{model_};
  FaceMeshes next_;
};

TEST_F(ProtectedNeighbors, AreThoseThatWereGoodAndAreBadNow) {
  spoil(true);
  EXPECT_FALSE(isSpoiledNeighbor(of_.retrial, next_, 0));
  EXPECT_TRUE(isSpoiledNeighbor(of_.retrial, next_, 1));
  EXPECT_FALSE(isSpoiledNeighbor(of_.retrial, next_, 2));
}

TEST_F(ProtectedNeighbors, TakeBackWhatAFaceAskedForThatDoesWithout) {
  spoil(false);
  EXPECT_EQ(protectNeighbor(of_.retrial, next_, 1), 1u);
  EXPECT_FALSE(of_.retrial.requests.has(0));
  EXPECT_TRUE(of_.retrial.faces[0].isGivenUp);
  EXPECT_EQ(of_.retrial.withdrawn, (std::vector<std::size_t>{0}));
}

TEST_F(ProtectedNeighbors, SoftenWhatAFaceAskedForThatFailsWithoutFiveTimesAtMost) {
  spoil(true);
  EXPECT_EQ(protectNeighbor(of_.retrial, next_, 1), 1u);
  EXPECT_DOUBLE_EQ(sizeAtPlace(), 0.2);
  for (int i = 0; i < 4; ++i) EXPECT_TRUE(protectNeighbor(of_.retrial, next_, 1));
  EXPECT_FALSE(protectNeighbor(of_.retrial, next_, 1));
}

TEST_F(ProtectedNeighbors, LeaveFacesAloneThatLieApart) {
  spoil(true);
  EXPECT_FALSE(protectNeighbor(of_.retrial, next_, 2));
  EXPECT_DOUBLE_EQ(sizeAtPlace(), 0.1);
}

}  // namespace
}  // namespace af2::geometry
