// How often a mesh is made again to keep it within its bounds.
#include "geometry/meshing/chord_rounds.h"

#include <gtest/gtest.h>

#include "tests/support/planar_meshes.h"

namespace af2::geometry {
namespace {

/// A square of as many squares as are asked for, too far from its model by some factor.
MeasuredMesh farBy(double excess, int squares) {
  MeasuredMesh measured{squareGrid(squares), {}, {}};
  measured.deviations.excess = excess;
  if (excess > 1) measured.deviations.tooFar = {{{0, 0, 0}, 0.1}};
  return measured;
}

/// The numbers of squares of the meshes that are made, and the excess of the one that is kept.
struct Rounds {
  std::vector<int> made;
  double kept = 0;
};

Rounds roundsOf(const std::vector<MeasuredMesh>& meshes) {
  Rounds rounds;
  MeshingOptions options;
  rounds.kept = meshWithinChords(options, [&](const MeshingOptions&) {
                  const std::size_t next = std::min(rounds.made.size(), meshes.size() - 1);
                  rounds.made.push_back(int(meshes[next].mesh.elements.size()));
                  return meshes[next];
                }).deviations.excess;
  return rounds;
}

TEST(ChordRounds, EndWithinTheBounds) {
  const Rounds rounds = roundsOf({farBy(3, 2), farBy(2, 3), farBy(0.9, 4), farBy(0.8, 5)});
  EXPECT_EQ(rounds.made.size(), 3u);
  EXPECT_EQ(rounds.kept, 0.9);
}

TEST(ChordRounds, GoOnAfterRoundsThatAreNoBetter) {
  const Rounds rounds = roundsOf({farBy(3, 2), farBy(2, 3), farBy(2.5, 4), farBy(2.5, 5),
                                  farBy(2.5, 6), farBy(1.5, 7), farBy(0.9, 8)});
  EXPECT_EQ(rounds.made.size(), 7u);
  EXPECT_EQ(rounds.kept, 0.9);
}

TEST(ChordRounds, EndAfterFourThatAreNoBetter) {
  const Rounds rounds =
      roundsOf({farBy(2, 2), farBy(3, 3), farBy(3, 4), farBy(3, 5), farBy(3, 6), farBy(0.9, 7)});
  EXPECT_EQ(rounds.made.size(), 5u);
  EXPECT_EQ(rounds.kept, 2);
}

TEST(ChordRounds, EndWhereTheSameMeshComesAgain) {
  const Rounds rounds = roundsOf({farBy(3, 2), farBy(2, 3), farBy(2, 3)});
  EXPECT_EQ(rounds.made.size(), 3u);
  EXPECT_EQ(rounds.kept, 2);
}

/// Large elements get a lower aim in each round, which need not change the mesh at once.
TEST(ChordRounds, GoOnWithTheSameMeshWhileTheAimFalls) {
  MeasuredMesh large = farBy(1.1, 2);
  large.deviations.tooFar.clear();
  large.deviations.scatter = {{1, 1.1}};
  const Rounds rounds = roundsOf({large, large, farBy(0.9, 3)});
  EXPECT_EQ(rounds.made.size(), 3u);
  EXPECT_EQ(rounds.kept, 0.9);
}

}  // namespace
}  // namespace af2::geometry
