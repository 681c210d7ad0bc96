// Short edges at corners, through the segments beside them.
#include "geometry/occ/edges/corner_edges.h"

#include <gtest/gtest.h>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <TopoDS.hxx>

#include <algorithm>
#include <cmath>

#include "geometry/occ/edges/edge_division.h"
#include "tests/geometry/occ/meshing.h"
#include "tests/support/model_mesh.h"

namespace af2::geometry {
namespace {

TopoDS_Face polygon(const std::vector<gp_Pnt>& corners) {
  BRepBuilderAPI_MakePolygon wire;
  for (const gp_Pnt& corner : corners) wire.Add(corner);
  wire.Close();
  return BRepBuilderAPI_MakeFace(wire.Wire(), true).Face();
}

/// A square of 10 with a corner cut off, so that the edge there is as long as that.
TopoDS_Face cornerCutBy(double length) {
  const double side = length * std::sqrt(0.5);
  return polygon({{0, 0, 0}, {10, 0, 0}, {10, 10 - side, 0}, {10 - side, 10, 0}, {0, 10, 0}});
}

/// The longest segment that touches a place, of a mesh of size 1.
double longestAt(const TopoDS_Shape& shape, const Point3& place) {
  CadSizes sizes;
  sizes.size = 1;
  const Model model = testing::modelOf(shape);
  const DividedEdges divided =
      divideEdges(model.shape(), sampleEdges(model.shape(), sizes, 1, {}), sizes, 1, {});
  double longest = 0;
  for (const DividedEdge& edge : divided.edges)
    for (std::size_t i = 1; i < edge.points.size(); ++i) {
      const Point3 &a = divided.points[edge.points[i - 1]], &b = divided.points[edge.points[i]];
      if (std::min(distance(a, place), distance(b, place)) < 1e-9)
        longest = std::max(longest, distance(a, b));
    }
  return longest;
}

TEST(CornerEdges, HaveSegmentsBesideThemThatAreNotMuchLonger) {
  for (const double length : {0.4, 0.15, 0.03}) {
    const Point3 corner{10, 10 - length * std::sqrt(0.5), 0};
    for (const TopoDS_Shape& face :
         {TopoDS_Shape(cornerCutBy(length)), cornerCutBy(length).Reversed()})
      EXPECT_LT(longestAt(face, corner), 2.5 * length + 0.01);
    const ModelMesh mesh = testing::mesh(testing::modelOf(cornerCutBy(length)), 1);
    testing::expectComplete(mesh);
    EXPECT_GT(testing::leastAngle(mesh), 20);
  }
}

TEST(CornerEdges, MayLieInLineWithTheEdgesBesideThem) {
  const TopoDS_Face face = polygon({{0, 0, 0}, {5, 0, 0}, {5.1, 0, 0}, {10, 0, 0}, {10, 10, 0}});
  EXPECT_LT(longestAt(face, {5, 0, 0}), 0.25);
  EXPECT_LT(longestAt(face, {5.1, 0, 0}), 0.25);
}

TEST(CornerEdges, AtTheEndOfASlotCount) {
  const TopoDS_Face face = polygon({{0, 0, 0},
                                    {10, 0, 0},
                                    {10, 10, 0},
                                    {5.1, 10, 0},
                                    {5.1, 5, 0},
                                    {5, 5, 0},
                                    {5, 10, 0},
                                    {0, 10, 0}});
  EXPECT_LT(longestAt(face, {5, 5, 0}), 0.25);
}

TEST(CornerEdges, AtTheEndOfAStripDoNotCount) {
  const TopoDS_Face strip = polygon({{0, 0, 0}, {10, 0, 0}, {10, 0.05, 0}, {0, 0.05, 0}});
  EXPECT_GT(longestAt(strip, {0, 0, 0}), 0.9);
}

TEST(CornerEdges, OfTinyLengthGetNoTinySegmentsBesideThem) {
  EXPECT_GT(longestAt(cornerCutBy(0.001), {10, 10 - 0.001 * std::sqrt(0.5), 0}), 0.015);
}

TEST(CornerEdges, WithASizeOfTheirOwnCountAsThat) {
  MeshingOptions options = testing::ofSize(1);
  for (int edge = 1; edge <= 5; ++edge) options.sizes.edgeSizes[edge] = 1;
  const ModelMesh mesh = testing::mesh(testing::modelOf(cornerCutBy(0.1)), options);
  EXPECT_EQ(mesh.segments.size(), 41u);
}

}  // namespace
}  // namespace af2::geometry
