// Boundaries of faces that are not as they should be: what is put right, and that the rest is told.
#include <gtest/gtest.h>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepBuilderAPI_MakeVertex.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Geom2d_Curve.hxx>
#include <Geom_Circle.hxx>
#include <Geom_Plane.hxx>
#include <Geom_SurfaceOfRevolution.hxx>
#include <Geom_TrimmedCurve.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <gp_Ax2.hxx>
#include <gp_Circ.hxx>
#include <gp_Pln.hxx>

#include <cmath>
#include <initializer_list>
#include <numbers>
#include <utility>
#include <vector>

#include "geometry/occ/run/mesh_model.h"
#include "tests/geometry/occ/meshing.h"
#include "tests/support/model_mesh.h"

namespace af2::geometry {
namespace {

using std::numbers::pi;

using testing::expectComplete;
using testing::mesh;
using testing::plane;
using testing::rectangle;

/// Of the plane z = 0, with wires that need be no good boundary.
TopoDS_Face faceWithin(std::initializer_list<TopoDS_Wire> wires) {
  BRep_Builder builder;
  TopoDS_Face face;
  builder.MakeFace(face, new Geom_Plane(gp_Pln(gp_Ax3({0, 0, 0}, {0, 0, 1}))), 1e-7);
  for (const TopoDS_Wire& wire : wires) builder.Add(face, wire);
  return face;
}

/// Two squares with a bridge between them. To open the angles there would take a million elements.
TEST(FaceBoundaries, ABridgeThatCannotBeSeenIsNone) {
  BRepBuilderAPI_MakePolygon ring;
  for (const auto& [x, y] : {std::pair{0.0, 0.0},
                             {5.0, 0.0},
                             {5.0, 1.0},
                             {4.0, 1.0},
                             {4.0, 1e-6},
                             {1.0, 1e-6},
                             {1.0, 1.0},
                             {0.0, 1.0}})
    ring.Add({x, y, 0});
  ring.Close();
  const ModelMesh result = mesh(plane({ring.Wire()}), 0.5);
  expectComplete(result, 2, 1e-5);
  EXPECT_LT(result.elements.size(), 100u);
}

/// A full turn, the sides of whose seam the file puts two turns apart.
TEST(FaceBoundaries, TheAreaWithinAWrongSeamDoesNotCount) {
  const Handle(Geom_Circle) bow = new Geom_Circle(gp_Ax2({3, 0, 0}, {0, -1, 0}, {1, 0, 0}), 1);
  const Handle(Geom_Surface) tube = new Geom_SurfaceOfRevolution(bow, gp_Ax1({0, 0, 0}, {0, 0, 1}));
  const TopoDS_Face face = BRepBuilderAPI_MakeFace(tube, 0, 2 * pi, 0, pi / 2, 1e-7).Face();
  for (TopExp_Explorer it(face, TopAbs_EDGE); it.More(); it.Next()) {
    double first, last;
    const auto edge = TopoDS::Edge(it.Current());
    const Handle(Geom2d_Curve) curve = BRep_Tool::CurveOnSurface(edge, face, first, last);
    if (!BRep_Tool::IsClosed(edge, face) || curve->Value(first).X() > 1) continue;
    curve->Translate(gp_Vec2d(-2 * pi, 0));
    break;
  }
  const ModelMesh result = mesh(face, 0.2);
  expectComplete(result, 2 * pi * (3 * pi / 2 + 1));
  EXPECT_EQ(result.faces[0].area, 0);
}

TEST(FaceBoundaries, AHoleThatRunsTheWrongWayIsTurned) {
  const TopoDS_Face face = plane({rectangle(-1, -1, 1, 1), rectangle(-0.5, -0.5, 0.5, 0.5)});
  const ModelMesh result = mesh(face, 0.3);
  expectComplete(result, 3, 1e-9);
  ASSERT_FALSE(result.faces[0].attempts.empty());
  EXPECT_NE(result.faces[0].attempts[0].find("wrong direction"), std::string::npos);
}

TEST(FaceBoundaries, AWholeBoundaryThatRunsTheWrongWayIsTurned) {
  TopoDS_Wire wire = rectangle(0, 0, 2, 1);
  wire.Reverse();
  const TopoDS_Face face = faceWithin({wire});
  expectComplete(mesh(face, 0.3), 2, 1e-9);
}

/// The hole has edges of its own, as a boolean operation leaves them, but the vertices of the outer
/// wire where it touches that.
TEST(FaceBoundaries, AHoleMayTouchTheOuterWireAlongAnEdge) {
  std::vector<TopoDS_Vertex> v;
  for (const gp_Pnt& p : {gp_Pnt(0, 0, 0), gp_Pnt(1, 0, 0), gp_Pnt(2, 0, 0), gp_Pnt(3, 0, 0),
                          gp_Pnt(3, 2, 0), gp_Pnt(0, 2, 0), gp_Pnt(2, 1, 0), gp_Pnt(1, 1, 0)})
    v.push_back(BRepBuilderAPI_MakeVertex(p));
  const auto wire = [&](std::initializer_list<std::size_t> order) {
    BRep_Builder builder;
    TopoDS_Wire made;
    builder.MakeWire(made);
    for (auto at = order.begin(); at != order.end(); ++at)
      builder.Add(made, BRepBuilderAPI_MakeEdge(
                            v[*at], v[at + 1 == order.end() ? *order.begin() : *(at + 1)])
                            .Edge());
    return made;
  };
  const TopoDS_Face face = faceWithin({wire({0, 1, 2, 3, 4, 5}), wire({2, 1, 7, 6})});
  expectComplete(mesh(face, 0.3), 5, 1e-9);
}

/// Each edge has vertices of its own, a little beside those of its neighbours.
TEST(FaceBoundaries, GapsWithinTheToleranceAreClosed) {
  const std::vector<gp_Pnt> corners{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  BRep_Builder builder;
  TopoDS_Wire wire;
  builder.MakeWire(wire);
  for (std::size_t i = 0; i < 4; ++i) {
    const gp_Pnt& a = corners[i];
    const gp_Pnt& b = corners[(i + 1) % 4];
    const double gap = 1e-5;
    const gp_Pnt from(a.X() + gap, a.Y() + gap, 0);
    const TopoDS_Edge edge = BRepBuilderAPI_MakeEdge(from, b);
    for (const TopoDS_Vertex& v : {TopExp::FirstVertex(edge), TopExp::LastVertex(edge)})
      builder.UpdateVertex(v, 2e-5);
    builder.Add(wire, edge);
  }
  const TopoDS_Face face = faceWithin({wire});
  expectComplete(mesh(face, 0.3), 1, 1e-3);
}

TEST(FaceBoundaries, APlaneWithoutEdgesIsNamed) {
  const TopoDS_Face face = faceWithin({});
  const ModelMesh result = mesh(face, 0.3);
  EXPECT_EQ(result.faces[0].status, FaceStatus::Failed);
  EXPECT_NE(result.faces[0].reason.find("its edges are lost"), std::string::npos);
}

/// As damaged files have it: a vertex that claims to be everywhere.
TEST(FaceBoundaries, AToleranceAsLargeAsTheModelClosesNothing) {
  BRep_Builder builder;
  TopoDS_Wire wire;
  builder.MakeWire(wire);
  const TopoDS_Edge arc = BRepBuilderAPI_MakeEdge(gp_Circ(gp_Ax2({0, 0, 0}, {0, 0, 1}), 1), 0, pi);
  for (const TopoDS_Vertex& v : {TopExp::FirstVertex(arc), TopExp::LastVertex(arc)})
    builder.UpdateVertex(v, 1e100);
  builder.Add(wire, arc);
  const ModelMesh result = mesh(faceWithin({wire}), 0.3);
  EXPECT_EQ(result.faces[0].status, FaceStatus::Failed);
  EXPECT_NE(result.faces[0].reason.find("not closed"), std::string::npos);
}

/// Each of the two arcs passes by its vertex, and would cross the other one before it ends.
TEST(FaceBoundaries, CurvesThatPassByTheirVerticesEndThere) {
  BRep_Builder builder;
  TopoDS_Vertex low, high;
  builder.MakeVertex(low, {0, -0.85, 0}, 0.2);
  builder.MakeVertex(high, {0, 0.85, 0}, 0.2);
  const auto arc = [&](double x, double middle) {
    const Handle(Geom_Circle) circle = new Geom_Circle(gp_Ax2({x, 0, 0}, {0, 0, 1}), 1);
    TopoDS_Edge edge;
    builder.MakeEdge(edge, circle, 0.2);
    const bool isRight = x < 0;
    builder.Add(edge, (isRight ? low : high).Oriented(TopAbs_FORWARD));
    builder.Add(edge, (isRight ? high : low).Oriented(TopAbs_REVERSED));
    builder.Range(edge, middle - 1.2, middle + 1.2);
    return edge;
  };
  TopoDS_Wire wire;
  builder.MakeWire(wire);
  builder.Add(wire, arc(-0.5, 0));
  builder.Add(wire, arc(0.5, pi));
  const TopoDS_Face face = faceWithin({wire});
  const double lens = 2 * (std::acos(0.5) - 0.5 * std::sqrt(0.75));
  expectComplete(mesh(face, 0.1), lens);
}

/// A seam as two edges, each with vertices of its own.
TEST(FaceBoundaries, ASphereWithTwoEdgesAlongItsSeamIsClosed) {
  const Handle(Geom_Circle) meridian = new Geom_Circle(gp_Ax2({0, 0, 0}, {0, -1, 0}, {1, 0, 0}), 1);
  const Handle(Geom_Curve) half = new Geom_TrimmedCurve(meridian, -pi / 2, pi / 2);
  const Handle(Geom_Surface) sphere =
      new Geom_SurfaceOfRevolution(half, gp_Ax1({0, 0, 0}, {0, 0, 1}));
  BRep_Builder builder;
  TopoDS_Wire wire;
  builder.MakeWire(wire);
  builder.Add(wire, BRepBuilderAPI_MakeEdge(meridian, -pi / 2, pi / 2).Edge());
  builder.Add(wire, BRepBuilderAPI_MakeEdge(meridian, -pi / 2, pi / 2).Edge().Reversed());
  TopoDS_Face face;
  builder.MakeFace(face, sphere, 1e-7);
  builder.Add(face, wire);
  const ModelMesh result = mesh(face, 0.3);
  expectComplete(result, 4 * pi);
  for (const EdgeSegment& segment : result.segments) EXPECT_EQ(segment.uses, 1);
}

/// Files with tolerances as large as their faces have such: a quarter of a tube, one of whose edges
/// lies on the other side in the parameters.
TEST(FaceBoundaries, CurvesInParametersThatRunElsewhereAreFoundAnew) {
  const Handle(Geom_Circle) bow = new Geom_Circle(gp_Ax2({3, 0, 0}, {0, -1, 0}, {1, 0, 0}), 1);
  const Handle(Geom_Surface) tube = new Geom_SurfaceOfRevolution(bow, gp_Ax1({0, 0, 0}, {0, 0, 1}));
  const TopoDS_Face face = BRepBuilderAPI_MakeFace(tube, 0, pi / 2, 0, pi / 2, 1e-7).Face();
  for (TopExp_Explorer it(face, TopAbs_EDGE); it.More(); it.Next()) {
    double first, last;
    const auto edge = TopoDS::Edge(it.Current());
    const Handle(Geom2d_Curve) curve = BRep_Tool::CurveOnSurface(edge, face, first, last);
    if (curve->Value(first).Distance(gp_Pnt2d(0, 0)) > 1e-9) continue;
    curve->Translate(gp_Vec2d(pi, 0));
    break;
  }
  const ModelMesh result = mesh(face, 0.2);
  expectComplete(result, pi / 2 * (3 * pi / 2 + 1));
  EXPECT_EQ(result.faces[0].attempts.size(), 1u);
}

TEST(FaceBoundaries, AGapBeyondTheToleranceIsNamed) {
  BRep_Builder builder;
  TopoDS_Wire wire;
  builder.MakeWire(wire);
  builder.Add(wire, BRepBuilderAPI_MakeEdge(gp_Pnt(0, 0, 0), gp_Pnt(1, 0, 0)).Edge());
  builder.Add(wire, BRepBuilderAPI_MakeEdge(gp_Pnt(1, 0.1, 0), gp_Pnt(0, 1, 0)).Edge());
  const ModelMesh result = mesh(faceWithin({wire}), 0.3);
  EXPECT_EQ(result.faces[0].status, FaceStatus::Failed);
  EXPECT_NE(result.faces[0].reason.find("not closed"), std::string::npos);
  EXPECT_NE(result.faces[0].reason.find("ends at (1, 0, 0)"), std::string::npos);
}

}  // namespace
}  // namespace af2::geometry
