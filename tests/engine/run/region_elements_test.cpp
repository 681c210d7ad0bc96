// How many elements are expected in the pieces of a region.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/run/mesh_region.h"
#include "tests/support/meshing.h"

namespace af2 {
namespace {

using namespace af2::testing;

constexpr std::size_t kEdges = 8000;

/// In a disc of radius 1, growing from its fine boundary up to a tenth; outside of it none.
struct FromTheRim final : SizeField {
  double sizeAt(const SurfacePoint& p) const override {
    const double atRim = 2 * std::numbers::pi / kEdges;
    return std::clamp(atRim + .15 * (1 - std::hypot(p.position.x, p.position.y)), 0., .1);
  }
};

SplitRegion splitDisc(bool clockwise) {
  FrontInput input;
  addLoop(input, circle({0, 0}, 1, kEdges, clockwise));
  return splitRegion(input, FlatPoints(), FromTheRim(), {40'000});
}

double expectedIn(const SplitRegion& split) {
  double sum = 0;
  for (const RegionPiece& piece : split.pieces) sum += piece.expectedElements;
  return sum;
}

TEST(RegionElements, BesideAFineBoundaryAreCounted) {
  const SplitRegion split = splitDisc(false);
  const auto tools = [] {
    return PieceTools{std::make_unique<FlatMaker>(), std::make_shared<FromTheRim>()};
  };
  ASSERT_GT(split.pieces.size(), 3u);
  double made = 0;
  for (const RegionPiece& piece : split.pieces) {
    const RegionMesh mesh =
        meshRegion(AF2Algorithm(triangleSet()), {piece.input, tools, nullptr, {}, false, 1}, {});
    EXPECT_EQ(mesh.result.outcome, Outcome::Complete);
    EXPECT_LT(mesh.result.mesh.elements.size(), 60'000u);
    made += static_cast<double>(mesh.result.mesh.elements.size());
  }
  EXPECT_NEAR(expectedIn(split), made, .2 * made);
}

/// It is on the right of its loops then.
TEST(RegionElements, AreAsManyInAReversedRegion) {
  const double expected = expectedIn(splitDisc(false));
  EXPECT_NEAR(expectedIn(splitDisc(true)), expected, .1 * expected);
}

}  // namespace
}  // namespace af2
