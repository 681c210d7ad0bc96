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

TEST(ChordRounds, GoOnWhileTheMeshChanges) {
  const Rounds rounds = roundsOf({farBy(3, 2), farBy(2, 3), farBy(2.5, 4), farBy(1.5, 5),
                                  farBy(1.6, 6), farBy(1.1, 7), farBy(0.9, 8)});
  EXPECT_EQ(rounds.made.size(), 7u);
  EXPECT_EQ(rounds.kept, 0.9);
}

TEST(ChordRounds, EndWhereTheSameMeshComesAgain) {
  const Rounds rounds = roundsOf({farBy(3, 2), farBy(2, 3), farBy(2, 3)});
  EXPECT_EQ(rounds.made.size(), 3u);
  EXPECT_EQ(rounds.kept, 2);
}

}  // namespace
}  // namespace af2::geometry
