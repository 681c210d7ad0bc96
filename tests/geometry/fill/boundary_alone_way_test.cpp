#include "geometry/fill/boundary_alone_way.h"

#include <gtest/gtest.h>

#include "tests/geometry/fill/flat_face.h"

namespace af2::geometry {
namespace {

TEST(BoundaryAloneWay, IsForNarrowStrips) {
  testing::FlatFace strip(testing::stripLoop(), 1);
  EXPECT_FALSE(needsNoVertices({strip.task()})) << "nobody knows how wide it is";
  strip.area = 0.15;
  EXPECT_TRUE(needsNoVertices({strip.task()}));
  testing::FlatFace square(testing::squareLoop());
  square.area = 16;
  EXPECT_FALSE(needsNoVertices({square.task()}));
  EXPECT_FALSE(mayNeedNoVertices({square.task()}));
}

TEST(BoundaryAloneWay, FillsANarrowStripWithoutAFront) {
  testing::FlatFace strip(testing::stripLoop(), 1);
  strip.area = 0.15;
  const FilledFace filled = fillFace(strip.task());
  EXPECT_TRUE(filled.attempt.fault.isNone());
  EXPECT_EQ(filled.searchCost, 0u);
  EXPECT_EQ(filled.attempt.result.mesh.elements.size(), 6u);
  EXPECT_TRUE(filled.history.empty());
}

TEST(BoundaryAloneWay, LeavesAStripToTheRulesWhereOnlyTheyMayMakeElements) {
  testing::FlatFace strip(testing::stripLoop(), 1);
  strip.area = 0.15;
  strip.options.strictRules = true;
  EXPECT_GT(fillFace(strip.task()).searchCost, 0u);
}

TEST(BoundaryAloneWay, PutsNoVerticesInside) {
  const testing::FlatFace strip(testing::stripLoop(), 1);
  const FaceTask task = strip.task();
  FillState state{task};
  const FaceAttempt filled = fillFromBoundary(state);
  EXPECT_TRUE(filled.fault.isNone());
  EXPECT_EQ(filled.result.mesh.vertices.size(), 8u);
  EXPECT_EQ(filled.chart, ChartKind::Auto);
  EXPECT_EQ(filled.searchCost, 0u);
}

TEST(BoundaryAloneWay, IsTakenIfNothingElseGaveAMesh) {
  testing::FlatFace strip(testing::stripLoop(), 1);
  strip.area = 0.15;
  const FaceTask task = strip.task();
  FillState state{task};
  EXPECT_TRUE(isBetterWithoutVertices(state, fillFromBoundary(state)));
}

TEST(BoundaryAloneWay, IsNotBetterWhereAStripIsFarWiderThanItsSegmentsAreLong) {
  testing::FlatFace face(testing::divided({{0, 0}, {4, 0}, {4, 4}, {0, 4}}, 0.5));
  face.area = 0.1;  // as if it were narrow
  const FaceTask task = face.task();
  FillState state{task};
  const FaceAttempt filled = fillFromBoundary(state);
  ASSERT_TRUE(filled.fault.isNone());
  EXPECT_FALSE(isBetterWithoutVertices(state, filled));
}

}  // namespace
}  // namespace af2::geometry
