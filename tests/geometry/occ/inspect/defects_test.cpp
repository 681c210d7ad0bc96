#include "geometry/occ/inspect/defects.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/geometry/occ/run/dirt.h"
#include "tests/geometry/occ/shapes.h"

namespace af2::geometry {
namespace {

std::vector<Defect> defectsOf(const TopoDS_Shape& shape, double size = 0.3) {
  return findDefects(testing::modelOf(shape), size);
}

std::vector<Defect> ofKind(const std::vector<Defect>& defects, DefectKind kind) {
  std::vector<Defect> some;
  std::ranges::copy_if(defects, std::back_inserter(some),
                       [&](const Defect& defect) { return defect.kind == kind; });
  return some;
}

TEST(FindDefects, FindsNoneInSoundModels) {
  EXPECT_TRUE(findDefects(testing::box(1, 2, 3), 0.3).empty());
  EXPECT_TRUE(findDefects(testing::cylinder(1, 3), 0.3).empty());
  EXPECT_TRUE(findDefects(testing::cone(1, 0, 3), 0.3).empty());
  EXPECT_TRUE(findDefects(testing::sphere(1), 0.3).empty());
  EXPECT_TRUE(findDefects(testing::torus(2, 0.5), 0.3).empty());
}

TEST(FindDefects, TinyEdgesAndSliversDependOnTheMeshSize) {
  const Model plate = testing::box(1, 1, 0.01);
  const auto coarse = findDefects(plate, 0.3);
  EXPECT_EQ(ofKind(coarse, DefectKind::TinyEdge).size(), 4u);
  ASSERT_EQ(ofKind(coarse, DefectKind::Sliver).size(), 4u);
  EXPECT_NEAR(ofKind(coarse, DefectKind::Sliver)[0].extent, 0.01, 1e-3);
  EXPECT_NEAR(ofKind(coarse, DefectKind::TinyEdge)[0].extent, 0.01, 1e-9);
  EXPECT_TRUE(findDefects(plate, 0.05).empty());
}

TEST(FindDefects, TheWorstComesFirst) {
  const auto tiny = ofKind(defectsOf(testing::tinyStep(1e-3), 20), DefectKind::TinyEdge);
  ASSERT_GT(tiny.size(), 4u);
  EXPECT_TRUE(std::ranges::is_sorted(tiny, {}, &Defect::extent));
}

TEST(FindDefects, FreeEdgesOfASheet) {
  const auto defects = defectsOf(testing::polygon({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}}));
  EXPECT_EQ(ofKind(defects, DefectKind::FreeEdge).size(), 3u);
  EXPECT_EQ(defects.size(), 3u);
}

TEST(FindDefects, NonManifoldEdgesAroundASharedFace) {
  const auto defects = defectsOf(testing::sharedFace());
  const auto edges = ofKind(defects, DefectKind::NonManifoldEdge);
  ASSERT_EQ(edges.size(), 4u);
  EXPECT_EQ(edges[0].detail, "3 times in faces");
  EXPECT_NEAR(edges[0].place.x, 1, 1e-9);
}

TEST(FindDefects, FacesThatAreTurnedAgainstTheirNeighbours) {
  EXPECT_EQ(ofKind(defectsOf(testing::turnedFace()), DefectKind::TurnedFaces).size(), 4u);
}

TEST(FindDefects, LoopsThatTouchOrAreOpen) {
  const auto touching = ofKind(defectsOf(testing::touchingLoop()), DefectKind::TouchingLoop);
  ASSERT_EQ(touching.size(), 1u);
  EXPECT_EQ(touching[0].place, (Point3{1, 1, 0}));
  const auto open = ofKind(defectsOf(testing::openLoop()), DefectKind::OpenLoop);
  ASSERT_EQ(open.size(), 2u);
  EXPECT_NEAR(open[0].extent, 1, 1e-9);
  EXPECT_EQ(open[0].detail,
            "the nearest other open end is at vertex " + std::to_string(open[1].vertex));
}

TEST(FindDefects, LoopsThatCross) {
  const auto invalid = ofKind(defectsOf(testing::crossingLoop()), DefectKind::Invalid);
  EXPECT_TRUE(std::ranges::any_of(
      invalid, [](const Defect& defect) { return defect.detail == "a loop crosses itself"; }));
}

TEST(FindDefects, EdgesWithoutCurvesAndFacesWithoutSurface) {
  EXPECT_EQ(ofKind(defectsOf(testing::withoutCurves()), DefectKind::NoCurve).size(), 4u);
  TopoDS_Face bare;
  BRep_Builder().MakeFace(bare);
  EXPECT_EQ(ofKind(defectsOf(bare), DefectKind::NoSurface).size(), 1u);
}

TEST(FindDefects, GapsBetweenEdgesAndTheirVertices) {
  BRep_Builder builder;
  const TopoDS_Face square = testing::polygon({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}});
  const TopExp_Explorer first(square, TopAbs_VERTEX);
  const TopoDS_Vertex vertex = TopoDS::Vertex(first.Current());
  builder.UpdateVertex(vertex, gp_Pnt(0, 0, 0.01), 0.02);
  const auto gaps = ofKind(defectsOf(square), DefectKind::Gap);
  ASSERT_EQ(gaps.size(), 2u);
  EXPECT_NEAR(gaps[0].extent, 0.01, 1e-9);
  EXPECT_EQ(gaps[0].detail, "within the tolerance");
}

TEST(PointsAlong, FollowTheCurveOfAnEdge) {
  const Model model = testing::cylinder(1, 2);
  double longest = 0;
  for (int edge = 1; edge <= model.edgeCount(); ++edge) {
    const auto points = pointsAlong(model, edge);
    double length = 0;
    for (std::size_t i = 1; i < points.size(); ++i) length += distance(points[i - 1], points[i]);
    longest = std::max(longest, length);
  }
  EXPECT_NEAR(longest, 6.2832, 0.02);
  EXPECT_EQ(edgesAround(model, 1).size(), 3u);
}

}  // namespace
}  // namespace af2::geometry
