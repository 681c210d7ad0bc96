// Regions that the engine does not take, and what it says.
#include "engine/front/input_check.h"

#include <gtest/gtest.h>

#include <limits>

#include "engine/base/error.h"
#include "engine/run/algorithm.h"
#include "tests/support/meshing.h"

namespace af2 {
namespace {

using namespace af2::testing;

MeshingResult run(const FrontInput& input, double size) {
  return AF2Algorithm(triangleSet()).execute(FlatMaker(), input, UniformSize(size), {});
}

std::string errorOf(const FrontInput& input) {
  try {
    run(input, .1);
    return "no error";
  } catch (const InputError& e) {
    return e.what();
  }
}

TEST(InputRejection, OfNoRuleSet) { EXPECT_THROW(AF2Algorithm(nullptr), InputError); }

TEST(InputRejection, OfALoopOfOneCorner) {
  FrontInput input = square(.5);
  input.loops[0].resize(1);
  EXPECT_EQ(errorOf(input), "boundary: a loop has fewer than two corners");
}

TEST(InputRejection, OfAnEdgeOfLengthZero) {
  FrontInput input;
  addLoop(input, {{0, 0}, {1, 0}, {1, 0}, {0, 1}});
  EXPECT_EQ(errorOf(input), "boundary: the edge from vertex 1 to vertex 2 has length zero");
}

TEST(InputRejection, OfAnIdOutOfRange) {
  FrontInput input = square(.5);
  input.vertexCount = 5;
  EXPECT_EQ(errorOf(input), "boundary: vertex 5 is not below the vertex count 5");
}

TEST(InputRejection, OfAnEdgeGivenTwice) {
  FrontInput input = square(.5);
  input.loops.push_back(input.loops[0]);
  EXPECT_EQ(errorOf(input),
            "boundary: the edge from vertex 0 to vertex 1 is given twice in the same direction");
}

TEST(InputRejection, OfAVertexWithTwoPositions) {
  FrontInput input = square(.5);
  BoundaryCorner corner = input.loops[0][0];
  corner.point.position.x += 1e-9;
  input.isolated.push_back(corner);
  EXPECT_EQ(errorOf(input), "boundary: vertex 0 is given with two positions");
}

TEST(InputRejection, OfACoordinateThatIsNotFinite) {
  FrontInput input = square(.5);
  input.loops[0][2].point.position.z = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(errorOf(input), "boundary: vertex 2 has a coordinate that is not a finite number");
}

TEST(InputRejection, OfAnIsolatedVertexThatIsOnTheBoundary) {
  FrontInput input = square(.5);
  input.isolated.push_back(input.loops[0][1]);
  EXPECT_NE(errorOf(input), "no error");
}

TEST(InputRejection, OfAnIsolatedVertexGivenTwice) {
  FrontInput input = square(.5);
  const BoundaryCorner corner = flatCorner(input.vertexCount++, {.5, .5});
  input.isolated = {corner, corner};
  EXPECT_NE(errorOf(input), "no error");
}

TEST(InputRejection, OfAVertexThatIsNowhere) {
  // An id below the count that no corner has: its position would be made up.
  FrontInput input = square(.5);
  ++input.vertexCount;
  const MeshingResult result = run(input, .5);
  EXPECT_EQ(result.outcome, Outcome::Complete) << "it is simply not used";
}

TEST(InputRejection, OfABoundaryOfTheWrongOrientation) {
  // The region to the left of such a loop is the rest of the plane: the front would run outwards.
  FrontInput input;
  std::vector<Point2> clockwise = divided({{0, 0}, {1, 0}, {1, 1}, {0, 1}}, .25);
  std::reverse(clockwise.begin(), clockwise.end());
  addLoop(input, clockwise);
  EXPECT_EQ(errorOf(input),
            "boundary: its loops bound no area on their left, seen against the normals; reverse "
            "the loops that run the wrong way");
}

TEST(LimitsOfFlatRegion, LeaveRoomAroundIt) {
  const auto limits = limitsOfFlatRegion(square(.25));
  ASSERT_TRUE(limits);
  EXPECT_LT(limits->low.x, 0);
  EXPECT_GT(limits->high.y, 1);
}

TEST(LimitsOfFlatRegion, AreUnknownOfABentBoundary) {
  FrontInput input = square(.25);
  input.loops[0][2].point.position.z = .1;
  EXPECT_FALSE(limitsOfFlatRegion(input));
}

}  // namespace
}  // namespace af2
