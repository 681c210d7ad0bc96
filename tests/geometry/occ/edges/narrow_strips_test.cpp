// Edges of strips, through the division that they come out with.
#include "geometry/occ/edges/narrow_strips.h"

#include <gtest/gtest.h>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <TopoDS.hxx>

#include <algorithm>

#include "geometry/occ/edges/edge_division.h"
#include "tests/geometry/occ/meshing.h"
#include "tests/support/model_mesh.h"

namespace af2::geometry {
namespace {

using testing::uniform;

/// Lengths of the segments whose middles lie within a box.
std::vector<double> lengthsIn(const Model& model, const CadSizes& sizes, Point3 low, Point3 high) {
  const DividedEdges divided =
      divideEdges(model.shape(), sampleEdges(model.shape(), sizes, 1, {}), sizes, 1, {});
  std::vector<double> lengths;
  for (const DividedEdge& edge : divided.edges)
    for (std::size_t i = 1; i < edge.points.size(); ++i) {
      const Point3 &a = divided.points[edge.points[i - 1]], &b = divided.points[edge.points[i]];
      const Point3 m = 0.5 * (a + b);
      if (m.x >= low.x && m.y >= low.y && m.x <= high.x && m.y <= high.y)
        lengths.push_back(distance(a, b));
    }
  return lengths;
}

Model polygonModel(const std::vector<gp_Pnt>& corners) {
  BRepBuilderAPI_MakePolygon wire;
  for (const gp_Pnt& corner : corners) wire.Add(corner);
  wire.Close();
  return testing::modelOf(BRepBuilderAPI_MakeFace(wire.Wire(), true).Shape());
}

Model ring(double outside, double inside) {
  BRepBuilderAPI_MakeWire inner(TopoDS::Edge(testing::circle(inside).Reversed()));
  return testing::modelOf(
      testing::plane({BRepBuilderAPI_MakeWire(testing::circle(outside)).Wire(), inner.Wire()}));
}

TEST(NarrowStrips, HaveSegmentsAboutAsLongAsTheyAreWide) {
  const ModelMesh plate = testing::mesh(testing::box(10, 10, 0.3), 1);
  testing::expectComplete(plate);
  EXPECT_GT(testing::leastAngle(plate), 25);
  for (const double length : lengthsIn(testing::box(10, 10, 0.3), uniform(1), {1, -1}, {9, 11}))
    EXPECT_NEAR(length, 0.45, 0.1);
}

TEST(NarrowStrips, MayBeBetweenTheCirclesOfARing) {
  for (const double length : lengthsIn(ring(5, 4.7), uniform(1), {-6, -6}, {6, 6}))
    EXPECT_NEAR(length, 0.45, 0.05);
  for (const double length : lengthsIn(ring(5, 2), uniform(1), {-6, -6}, {6, 6}))
    EXPECT_NEAR(length, 1, 0.1);
}

TEST(NarrowStrips, MayBeBesideEdgesOfVeryManySegments) {
  for (const double length : lengthsIn(ring(5, 4.97), uniform(0.1), {-6, -6}, {6, 6}))
    EXPECT_NEAR(length, 0.045, 0.005);
  for (const double length : lengthsIn(ring(5, 4), uniform(0.1), {-6, -6}, {6, 6}))
    EXPECT_NEAR(length, 0.1, 0.01);
}

TEST(NarrowStrips, MayBeInAPartOfAFaceOnly) {
  const std::vector<gp_Pnt> bottle{{0, 0, 0},    {10, 0, 0}, {10, 10, 0}, {5.2, 10, 0},
                                   {5.2, 15, 0}, {5, 15, 0}, {5, 10, 0},  {0, 10, 0}};
  for (const double length : lengthsIn(polygonModel(bottle), uniform(1), {5, 11}, {5.2, 14.9}))
    EXPECT_NEAR(length, 0.3, 0.05);
  for (const double length : lengthsIn(polygonModel(bottle), uniform(1), {0, 0}, {10, 5}))
    EXPECT_NEAR(length, 1, 0.1);
}

TEST(NarrowStrips, AreNoGapsBesideAFace) {
  const std::vector<gp_Pnt> slit{{0, 0, 0},   {10, 0, 0}, {10, 10, 0}, {5.2, 10, 0},
                                 {5.2, 5, 0}, {5, 5, 0},  {5, 10, 0},  {0, 10, 0}};
  for (const double length : lengthsIn(polygonModel(slit), uniform(1), {5, 6.5}, {5.2, 10}))
    EXPECT_GT(length, 0.6);
}

TEST(NarrowStrips, AreNoWedges) {
  const std::vector<gp_Pnt> wedge{{0, 0, 0}, {10, 0, 0}, {10, 1, 0}};
  for (const double length : lengthsIn(polygonModel(wedge), uniform(1), {0, 0}, {9.9, 1}))
    EXPECT_NEAR(length, 1, 0.1);
}

TEST(NarrowStrips, StayAsTheyAreWhereSegmentsWouldBeFarTooShort) {
  for (const double length : lengthsIn(testing::box(10, 10, 0.05), uniform(1), {1, -1}, {9, 11}))
    EXPECT_NEAR(length, 1, 0.1);
}

TEST(NarrowStrips, MayHaveShorterSegmentsWhereTurnsAreToHaveTheirElements) {
  const Model strip = polygonModel({{0, 0, 0}, {10, 0, 0}, {10, 0.08, 0}, {0, 0.08, 0}});
  CadSizes sizes = uniform(1);
  for (const double length : lengthsIn(strip, sizes, {1, -1}, {9, 1})) EXPECT_GT(length, 0.9);
  sizes.elementsPerTurn = 12;
  sizes.edgeTurn = 0.5;
  for (const double length : lengthsIn(strip, sizes, {1, -1}, {9, 1}))
    EXPECT_NEAR(length, 0.12, 0.01);
}

TEST(NarrowStrips, LeaveToAnEdgeTheSizeThatItIsGiven) {
  CadSizes sizes = uniform(1);
  for (int edge = 1; edge <= 12; ++edge) sizes.edgeSizes[edge] = 1;
  for (const double length : lengthsIn(testing::box(10, 10, 0.3), sizes, {1, -1}, {9, 11}))
    EXPECT_NEAR(length, 1, 0.1);
}

TEST(NarrowStrips, AreTheSameIfThoseOfAnEarlierDivisionAreKnown) {
  const Model model = testing::box(10, 10, 0.3);
  const SampledEdges sampled = sampleEdges(model.shape(), uniform(1), 1, {});
  const auto divided = [&](const CadSizes& sizes, KnownStrips* known) {
    std::vector<std::vector<double>> parameters;
    for (const DividedEdge& edge :
         divideEdges(model.shape(), sampled, sizes, 1, {}, {}, {}, {}, {}, {}, known).edges)
      parameters.push_back(edge.parameters);
    return parameters;
  };
  KnownStrips known;
  const auto first = divided(uniform(1), &known);
  EXPECT_EQ(first, divided(uniform(1), nullptr));
  EXPECT_EQ(first, divided(uniform(1), &known));
  CadSizes smaller = uniform(1);
  smaller.function = PositionSize([](const Point3& p) { return 0.1 + 0.3 * length(p); });
  EXPECT_EQ(divided(smaller, &known), divided(smaller, nullptr));
  EXPECT_NE(divided(smaller, &known), first);
}

}  // namespace
}  // namespace af2::geometry
