// Edges that are taken for points because a face fails with them.
#include <gtest/gtest.h>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepBuilderAPI_Sewing.hxx>
#include <Geom_Circle.hxx>
#include <Geom_SurfaceOfRevolution.hxx>

#include <algorithm>
#include <numbers>
#include <string>
#include <string_view>
#include <utility>

#include "geometry/occ/edges/edge_division.h"
#include "tests/geometry/occ/meshing.h"
#include "tests/support/model_mesh.h"

namespace af2::geometry {
namespace {

using std::numbers::pi;

constexpr std::string_view kTold = "short, and collapsed to points because a face there failed";

/// A hemisphere of radius 7, made by a meridian that goes on past the pole by some angle, so that
/// the surface turns over there: its normals look inwards.
TopoDS_Face pastThePole(double turn, double angle) {
  const Handle(Geom_Curve) meridian =
      new Geom_Circle(gp_Ax2(gp_Pnt(0, 0, 0), gp_Dir(0, -1, 0), gp_Dir(1, 0, 0)), 7);
  const Handle(Geom_Surface) surface =
      new Geom_SurfaceOfRevolution(meridian, gp_Ax1(gp_Pnt(0, 0, 0), gp_Dir(0, 0, 1)));
  return BRepBuilderAPI_MakeFace(surface, 0, turn, 0, pi / 2 + angle, 1e-7);
}

bool tellsOfPoints(const FaceReport& face) {
  return std::ranges::any_of(
      face.attempts, [](const std::string& step) { return step.find(kTold) != std::string::npos; });
}

TEST(ShortEdges, AMeridianThatGoesOnPastThePoleEndsThere) {
  const ModelMesh result = testing::mesh(pastThePole(pi, 1e-3), 2.7);
  testing::expectComplete(result, pi * 49);
  EXPECT_GT(testing::leastAngle(result), 20);
  EXPECT_TRUE(tellsOfPoints(result.faces[0]));
  for (const Point3& p : result.vertices) EXPECT_NEAR(length(p), 7, 1e-6);
}

/// To try shorter edges again and again would take long, and be of no use.
TEST(ShortEdges, AlsoAllTheWayAroundAfterFewTries) {
  MeshingOptions options = testing::ofSize(2.7);
  int fronts = 0;
  options.observer = [&](int) {
    ++fronts;
    return nullptr;
  };
  const ModelMesh result = testing::mesh(testing::modelOf(pastThePole(2 * pi, 0.05)), options);
  EXPECT_LE(fronts, 2 * (1 + 2 + 3));  // with two kinds of charts: first, shorter, without edges
  testing::expectComplete(result, 2 * pi * 49);
  EXPECT_GT(testing::leastAngle(result), 15);
  EXPECT_TRUE(tellsOfPoints(result.faces[0]));
}

/// As long as a face can be meshed with them, they stay.
TEST(ShortEdges, AreKeptWhereNothingFails) {
  const ModelMesh result = testing::mesh(pastThePole(pi, -0.02), 2.7);
  testing::expectComplete(result, pi * 49);
  EXPECT_FALSE(tellsOfPoints(result.faces[0]));
}

/// A block with a small dome on it that goes on past its pole, so that its surface turns over.
TopoDS_Shape blockWithABadDome(double radius) {
  BRepBuilderAPI_Sewing sewing(1e-6);
  const gp_Pnt low(-3, -3, -6), high(3, 3, 0);
  for (TopExp_Explorer it(BRepPrimAPI_MakeBox(low, high).Shape(), TopAbs_FACE); it.More();
       it.Next())
    if (BRepAdaptor_Surface(TopoDS::Face(it.Current())).Plane().Location().Z() < -1e-9 ||
        std::abs(BRepAdaptor_Surface(TopoDS::Face(it.Current())).Plane().Axis().Direction().Z()) <
            0.5)
      sewing.Add(it.Current());
  const auto wire = [](const TopoDS_Edge& edge) { return BRepBuilderAPI_MakeWire(edge).Wire(); };
  BRepBuilderAPI_MakeFace top(gp_Pln({0, 0, 0}, {0, 0, 1}), -3, 3, -3, 3);
  top.Add(TopoDS::Wire(wire(testing::circle(radius)).Reversed()));
  sewing.Add(top.Face());
  const Handle(Geom_Curve) meridian =
      new Geom_Circle(gp_Ax2(gp_Pnt(0, 0, 0), gp_Dir(0, -1, 0), gp_Dir(1, 0, 0)), radius);
  const Handle(Geom_Surface) surface =
      new Geom_SurfaceOfRevolution(meridian, gp_Ax1(gp_Pnt(0, 0, 0), gp_Dir(0, 0, 1)));
  sewing.Add(BRepBuilderAPI_MakeFace(surface, 0, 2 * pi, 0, pi / 2 + 0.6, 1e-7).Face());
  sewing.Perform();
  return sewing.SewedShape();
}

/// It failed with an empty reason, although all around it was closed.
TEST(ShortEdges, AFaceAllOfWhoseEdgesArePointsHasVanished) {
  const ModelMesh result = testing::mesh(blockWithABadDome(0.1), 1);
  testing::expectComplete(result);
  EXPECT_EQ(testing::eulerNumber(result), 2);
  const auto vanished = std::ranges::find(result.faces, 0u, &FaceReport::elements);
  ASSERT_NE(vanished, result.faces.end());
  EXPECT_NE(vanished->reason.find("smaller than any element"), std::string::npos);
  EXPECT_TRUE(tellsOfPoints(*vanished));
}

/// A cone whose upper circle is given, but within the tolerance of its vertex.
TopoDS_Shape almostPointedCone(double radius, double tolerance) {
  const TopoDS_Shape cone = BRepPrimAPI_MakeCone(5, radius, 10).Shape();
  for (TopExp_Explorer it(cone, TopAbs_VERTEX); it.More(); it.Next())
    if (BRep_Tool::Pnt(TopoDS::Vertex(it.Current())).Z() > 5)
      BRep_Builder().UpdateVertex(TopoDS::Vertex(it.Current()), tolerance);
  return cone;
}

/// A closed edge is longer than it is large, so that it was kept, and bridged by needles.
TEST(ShortEdges, AClosedOneWithinTheToleranceOfItsVertexIsAPoint) {
  for (const auto& [tolerance, vanished] : {std::pair{0.003, 1}, {1e-7, 0}}) {
    const ModelMesh result = testing::mesh(almostPointedCone(0.001, tolerance), 5);
    testing::expectComplete(result);
    EXPECT_EQ(testing::eulerNumber(result), 2);
    EXPECT_GT(testing::leastAngle(result), 15);
    EXPECT_EQ(std::ranges::count(result.faces, 0u, &FaceReport::elements), vanished);
  }
}

DividedEdges divided(const Model& model, double size, const CollapsedEdges& asPoints) {
  CadSizes sizes;
  sizes.size = size;
  return divideEdges(model.shape(), sampleEdges(model.shape(), sizes, 1, {}), sizes, 1, {}, {},
                     asPoints);
}

TEST(ShortEdges, OneThatIsAPointLeavesOneVertexToTheEdgesBeside) {
  const Model model = testing::box(0.1, 2, 2);
  const DividedEdges all = divided(model, 1, {});
  int shortEdge = 0;
  for (std::size_t i = 0; i < all.edges.size() && shortEdge == 0; ++i) {
    const auto& points = all.edges[i].points;
    if (distance(all.points[points.front()], all.points[points.back()]) < 0.2)
      shortEdge = static_cast<int>(i) + 1;
  }
  const auto& ends = all.edges[static_cast<std::size_t>(shortEdge) - 1].points;
  const DividedEdges fewer = divided(model, 1, {{shortEdge, 0.2}});
  for (std::size_t i = 0; i < fewer.edges.size(); ++i) {
    const DividedEdge& edge = fewer.edges[i];
    const bool isPoint = static_cast<int>(i) + 1 == shortEdge;
    EXPECT_EQ(edge.points.empty(), isPoint);
    EXPECT_EQ(edge.point.has_value(), isPoint);
    EXPECT_EQ(std::ranges::count(edge.points, std::max(ends.front(), ends.back())), 0);
  }
}

/// What becomes one point is no larger than asked for, however many edges lie in a row.
TEST(ShortEdges, OneThatWouldJoinPointsTooFarApartStays) {
  const DividedEdges kept = divided(testing::box(0.1, 2, 2), 1, {{1, 0.05}, {2, 0.05}, {3, 0.05}});
  for (const DividedEdge& edge : kept.edges) EXPECT_FALSE(edge.points.empty());
}

}  // namespace
}  // namespace af2::geometry
