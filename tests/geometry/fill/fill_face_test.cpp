#include "geometry/fill/fill_face.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>

#include "tests/geometry/fill/flat_face.h"

namespace af2::geometry {
namespace {

TEST(FillFace, TakesTheFirstWayThatGivesASoundMesh) {
  const testing::FlatFace face(testing::squareLoop());
  const FilledFace filled = fillFace(face.task());
  EXPECT_TRUE(filled.attempt.fault.isNone());
  EXPECT_EQ(filled.attempt.chart, ChartKind::Plane);
  EXPECT_TRUE(filled.history.empty());
  EXPECT_TRUE(filled.failures.empty());
  EXPECT_EQ(filled.searchCost, filled.attempt.searchCost);
}

TEST(FillFace, TellsWhyEachWayFailed) {
  const testing::FlatFace face(testing::crossedLoop());
  const FilledFace filled = fillFace(face.task());
  EXPECT_EQ(filled.attempt.fault.kind, FillFaultKind::EveryWayFailed);
  ASSERT_EQ(filled.history.size(), 1u);
  EXPECT_EQ(filled.history[0].name, "plane charts");
  EXPECT_EQ(filled.attempt.fault.details, textOf(filled.history[0]));
  EXPECT_EQ(filled.failures.size(), 1u);
}

TEST(FillFace, TriesNothingWhereSegmentsCrossOfAFaceThatFailedBefore) {
  testing::FlatFace face(testing::crossedLoop());
  face.limits.failedBefore = true;
  const FilledFace filled = fillFace(face.task());
  EXPECT_EQ(filled.attempt.fault.kind, FillFaultKind::CrossedBoundary);
  EXPECT_EQ(filled.searchCost, 0u);
  EXPECT_TRUE(filled.history.empty());
}

TEST(FillFace, LooksForNoCrossingsAtTheFirstTry) {
  const testing::FlatFace face(testing::crossedLoop());
  EXPECT_GT(fillFace(face.task()).searchCost, 0u);
}

TEST(FillFace, TriesOtherWaysWhereNormalsAreIgnored) {
  testing::FlatFace face(testing::squareLoop());
  face.limits.ignoresNormals = true;
  EXPECT_EQ(fillFace(face.task()).attempt.fault.kind, FillFaultKind::NotFilled)
      << "these are for curved faces";
}

TEST(FillFace, TriangulatesANarrowStripFromItsBoundaryIfThatIsBetter) {
  testing::FlatFace face(testing::stripLoop(), 1);
  face.area = 0.15;
  const FilledFace filled = fillFace(face.task());
  ASSERT_TRUE(filled.attempt.fault.isNone());
  EXPECT_EQ(filled.attempt.result.mesh.vertices.size(), 8u);
  EXPECT_EQ(filled.attempt.result.mesh.elements.size(), 6u);
}

TEST(FillFace, TriesTheChartsThatWereAskedForFirst) {
  testing::FlatFace face(testing::squareLoop());
  face.options.chart = ChartKind::Affine;
  EXPECT_EQ(fillFace(face.task()).attempt.chart, ChartKind::Plane) << "a plane has no others";
}

TEST(FillWays, HaveNamesOfTheirOwn) {
  std::set<std::string> names;
  for (const FillWay& way : fillWays()) {
    EXPECT_TRUE(names.insert(way.name).second) << way.name;
    EXPECT_TRUE(way.applies && way.fill) << way.name;
  }
}

}  // namespace
}  // namespace af2::geometry
