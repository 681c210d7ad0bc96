// Faces on which the first way fails: what is done then, and that it is told.
#include <gtest/gtest.h>
#include <BRepAlgoAPI_Cut.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepBuilderAPI_MakeVertex.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepBuilderAPI_Sewing.hxx>
#include <BRepGProp.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <GProp_GProps.hxx>
#include <Geom2d_Curve.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Geom_BezierSurface.hxx>
#include <Geom_Circle.hxx>
#include <Geom_Plane.hxx>
#include <Geom_SurfaceOfRevolution.hxx>
#include <Geom_TrimmedCurve.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColgp_Array2OfPnt.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <gp_Ax2.hxx>
#include <gp_Circ.hxx>
#include <gp_Elips.hxx>
#include <gp_Pln.hxx>

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <numbers>
#include <utility>

#include "geometry/element_crossings.h"
#include "geometry/occ/mesh_model.h"
#include "geometry/occ/sizing.h"
#include "tests/geometry/occ/dirt.h"
#include "tests/geometry/occ/meshing.h"
#include "tests/support/model_mesh.h"
#include "tests/support/triangle_rules.h"

namespace af2::geometry {
namespace {

using std::numbers::pi;

using testing::areaOf;
using testing::leastAngle;
using testing::mesh;

/// Complete, and of about the right area.
void expectComplete(const ModelMesh& mesh, double area, double tolerance = 0.05) {
  for (const FaceReport& face : mesh.faces)
    EXPECT_EQ(face.status, FaceStatus::Complete) << "face " << face.id << ": " << face.reason;
  EXPECT_TRUE(mesh.findings.empty());
  EXPECT_NEAR(areaOf(mesh), area, tolerance * area);
}

TopoDS_Edge circle(double radius) {
  return BRepBuilderAPI_MakeEdge(gp_Circ(gp_Ax2({0, 0, 0}, {0, 0, 1}), radius));
}

TopoDS_Wire rectangle(double x1, double y1, double x2, double y2, double z = 0) {
  BRepBuilderAPI_MakePolygon polygon({x1, y1, z}, {x2, y1, z}, {x2, y2, z}, {x1, y2, z}, true);
  return polygon.Wire();
}

TopoDS_Face plane(const std::vector<TopoDS_Wire>& wires) {
  BRepBuilderAPI_MakeFace maker(gp_Pln(gp_Ax3({0, 0, 0}, {0, 0, 1})), wires[0]);
  for (std::size_t i = 1; i < wires.size(); ++i) maker.Add(wires[i]);
  return maker.Face();
}

/// The wanted size would let the chords of the two circles cross.
TEST(DifficultFaces, ANarrowRingGetsShorterEdges) {
  BRepBuilderAPI_MakeWire inner(TopoDS::Edge(circle(1).Reversed()));
  const TopoDS_Face ring = plane({BRepBuilderAPI_MakeWire(circle(1.005)).Wire(), inner.Wire()});
  const ModelMesh result = mesh(ring, 0.6);
  expectComplete(result, pi * (1.005 * 1.005 - 1));
  EXPECT_FALSE(result.faces[0].attempts.empty());
}

/// Ten times shorter edges are not enough, though better.
TEST(DifficultFaces, AStripOfATwoThousandthOfTheSizeIsDividedFinely) {
  const ModelMesh result = mesh(plane({rectangle(0, 0, 2, 0.0005)}), 1);
  expectComplete(result, 0.001, 1e-9);
  EXPECT_GT(leastAngle(result), 0.5);
}

/// A frame as those of the sockets on a circuit board: a thousandth of its side wide.
TEST(DifficultFaces, AFrameHasElementsAsWideAsItself) {
  const TopoDS_Wire hole = TopoDS::Wire(rectangle(0.001, 0.001, 0.999, 0.999).Reversed());
  const ModelMesh result = mesh(plane({rectangle(0, 0, 1, 1), hole}), 2.5);
  expectComplete(result, 4 * 0.999 * 0.001, 1e-6);
  EXPECT_GT(leastAngle(result), 0.5);
  EXPECT_LT(result.elements.size(), 400u);
  for (const Point3& p : result.vertices)
    EXPECT_LT(std::min({p.x, p.y, 1 - p.x, 1 - p.y}), 0.00100001) << "a vertex inside";
}

/// To open the angles there would take a million elements.
TEST(DifficultFaces, ASlitThatCannotBeSeenIsNotDividedFinely) {
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
  expectComplete(result, 2 + 3e-6, 1e-6);
  EXPECT_LT(result.elements.size(), 100u);
}

/// A full turn, the sides of whose seam the file puts two turns apart.
TEST(DifficultFaces, TheAreaWithinAWrongSeamDoesNotCount) {
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

/// No division opens the angle of a corner, so none is tried.
TEST(DifficultFaces, ASharpCornerIsLeftAsItIs) {
  BRepBuilderAPI_MakePolygon wedge({0, 0, 0}, {10, 0, 0}, {10, 0.2, 0}, true);
  const ModelMesh result = mesh(plane({wedge.Wire()}), 1);
  expectComplete(result, 1, 1e-6);
  EXPECT_TRUE(result.faces[0].attempts.empty());
  EXPECT_LT(result.elements.size(), 40u);
}

/// The disc wants shorter edges for its area; on the crescent, whose sides touch at the tips, the
/// element there is the worse the shorter it is. The strip cannot be meshed without shorter edges.
TEST(DifficultFaces, ShorterEdgesForOneFaceDoNotSpoilItsNeighbor) {
  const gp_Ax2 axes({0, 0, 0}, {0, 0, 1}, {0, 1, 0});
  const gp_Pnt left(-1, 0, 0), right(1, 0, 0);
  const TopoDS_Edge upper = BRepBuilderAPI_MakeEdge(gp_Circ(axes, 1), right, left);
  const TopoDS_Edge lower = BRepBuilderAPI_MakeEdge(gp_Circ(axes, 1), left, right);
  const TopoDS_Edge outer = BRepBuilderAPI_MakeEdge(gp_Elips(axes, 1.05, 1), right, left);
  BRepBuilderAPI_Sewing sewing(1e-7);
  sewing.Add(plane({BRepBuilderAPI_MakeWire(upper, lower).Wire()}));
  sewing.Add(plane({BRepBuilderAPI_MakeWire(outer, TopoDS::Edge(upper.Reversed())).Wire()}));
  sewing.Perform();
  const TopoDS_Shape both =
      testing::compoundOf({sewing.SewedShape(), plane({rectangle(4, 0, 6, 0.001)})});
  const ModelMesh result = mesh(both, 0.8);
  expectComplete(result, pi * 1.025, 0.1);
  EXPECT_GT(leastAngle(result), 0.6);
}

/// A square of side 10 with ridges that are far sharper than the wanted size.
TopoDS_Face roughGround() {
  constexpr int kPoles = 21;
  TColgp_Array2OfPnt poles(1, kPoles, 1, kPoles);
  for (int i = 1; i <= kPoles; ++i)
    for (int k = 1; k <= kPoles; ++k)
      poles(i, k) =
          gp_Pnt(0.5 * (i - 1), 0.5 * (k - 1), i % 11 == 5 || (k % 13 == 6 && i > 10) ? 0.8 : 0);
  TColStd_Array1OfReal knots(1, kPoles - 2);
  TColStd_Array1OfInteger multiplicities(1, kPoles - 2);
  for (int i = 1; i <= kPoles - 2; ++i) {
    knots(i) = i;
    multiplicities(i) = i == 1 || i == kPoles - 2 ? 4 : 1;
  }
  const Handle(Geom_Surface) ground =
      new Geom_BSplineSurface(poles, knots, knots, multiplicities, multiplicities, 3, 3);
  return BRepBuilderAPI_MakeFace(ground, 1e-6);
}

TEST(DifficultFaces, AFrontFollowsSizesThatChangeFasterThanItsElements) {
  const TopoDS_Face ground = roughGround();
  ModelSizes sizes;
  sizes.size = 1;
  EXPECT_EQ(unevenFaces(testing::modelOf(ground).shape(), sizes, 1, {}), std::vector<int>{1});
  EXPECT_TRUE(unevenFaces(testing::modelOf(plane({rectangle(0, 0, 20, 20)})).shape(), sizes, 1, {})
                  .empty());
  GProp_GProps properties;
  BRepGProp::SurfaceProperties(ground, properties);
  const ModelMesh result = mesh(ground, sizes.size);
  expectComplete(result, properties.Mass());
  EXPECT_GT(leastAngle(result), 15);
}

/// One corner of the surface turns over by a little, so that the normals along an edge look back.
TEST(DifficultFaces, ACornerThatTurnsOverIsMeshedWithElementsThatLean) {
  TColgp_Array2OfPnt poles(1, 5, 1, 5);
  for (int i = poles.LowerRow(); i <= poles.UpperRow(); ++i)
    for (int k = poles.LowerCol(); k <= poles.UpperCol(); ++k)
      poles.SetValue(i, k,
                     i == poles.UpperRow() ? gp_Pnt(4 - 0.05 * (k - 1), -0.03 * (k - 1), 1.6)
                                           : gp_Pnt(i - 1, 0.4 * (k - 1), 0.1 * i * i));
  const Handle(Geom_Surface) surface = new Geom_BezierSurface(poles);
  const TopoDS_Face face = BRepBuilderAPI_MakeFace(surface, 1e-6);
  GProp_GProps properties;
  BRepGProp::SurfaceProperties(face, properties);
  const ModelMesh result = mesh(face, 1);
  expectComplete(result, properties.Mass());
  ASSERT_FALSE(result.faces[0].attempts.empty());
  EXPECT_EQ(result.faces[0].attempts.back(), "elements that lean against the surface");
}

TEST(DifficultFaces, AThinWireIsMeshedAllTheWayAround) {
  expectComplete(mesh(BRepPrimAPI_MakeCylinder(0.01, 2).Shape(), 0.5), 2 * pi * 0.01 * 2, 0.1);
}

TEST(DifficultFaces, AThinHalfTubeIsMeshedAcross) {
  expectComplete(mesh(BRepPrimAPI_MakeCylinder(0.01, 2, pi).Shape(), 0.5),
                 (pi + 2) * 0.01 * 2 + pi * 1e-4, 0.1);
}

TEST(DifficultFaces, AHoleOfAThousandthOfTheSizeStaysAHole) {
  BRepBuilderAPI_MakeWire hole(TopoDS::Edge(circle(0.0005).Reversed()));
  const ModelMesh result = mesh(plane({rectangle(-1, -1, 1, 1), hole.Wire()}), 0.5);
  expectComplete(result, 4);
  EXPECT_EQ(std::ranges::count(result.segments, 5, &EdgeSegment::edge) >= 6, true);
}

TEST(DifficultFaces, AHoleThatRunsTheWrongWayIsTurned) {
  const TopoDS_Face face = plane({rectangle(-1, -1, 1, 1), rectangle(-0.5, -0.5, 0.5, 0.5)});
  const ModelMesh result = mesh(face, 0.3);
  expectComplete(result, 3, 1e-9);
  ASSERT_FALSE(result.faces[0].attempts.empty());
  EXPECT_NE(result.faces[0].attempts[0].find("wrong way round"), std::string::npos);
}

TEST(DifficultFaces, AWholeBoundaryThatRunsTheWrongWayIsTurned) {
  TopoDS_Wire wire = rectangle(0, 0, 2, 1);
  wire.Reverse();
  TopoDS_Face face;
  BRep_Builder builder;
  builder.MakeFace(face, new Geom_Plane(gp_Pln(gp_Ax3({0, 0, 0}, {0, 0, 1}))), 1e-7);
  builder.Add(face, wire);
  expectComplete(mesh(face, 0.3), 2, 1e-9);
}

/// The hole has edges of its own, as a boolean operation leaves them, but the vertices of the outer
/// wire where it touches that.
TEST(DifficultFaces, AHoleMayTouchTheOuterWireAlongAnEdge) {
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
  BRep_Builder builder;
  TopoDS_Face face;
  builder.MakeFace(face, new Geom_Plane(gp_Pln(gp_Ax3({0, 0, 0}, {0, 0, 1}))), 1e-7);
  builder.Add(face, wire({0, 1, 2, 3, 4, 5}));
  builder.Add(face, wire({2, 1, 7, 6}));
  expectComplete(mesh(face, 0.3), 5, 1e-9);
}

/// Each edge has vertices of its own, a little beside those of its neighbours.
TEST(DifficultFaces, GapsWithinTheToleranceAreClosed) {
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
  TopoDS_Face face;
  builder.MakeFace(face, new Geom_Plane(gp_Pln(gp_Ax3({0, 0, 0}, {0, 0, 1}))), 1e-7);
  builder.Add(face, wire);
  expectComplete(mesh(face, 0.3), 1, 1e-3);
}

TEST(DifficultFaces, APlaneWithoutEdgesIsNamed) {
  BRep_Builder builder;
  TopoDS_Face face;
  builder.MakeFace(face, new Geom_Plane(gp_Pln(gp_Ax3({0, 0, 0}, {0, 0, 1}))), 1e-7);
  const ModelMesh result = mesh(face, 0.3);
  EXPECT_EQ(result.faces[0].status, FaceStatus::Failed);
  EXPECT_NE(result.faces[0].reason.find("its edges are lost"), std::string::npos);
}

/// As damaged files have it: a vertex that claims to be everywhere.
TEST(DifficultFaces, AToleranceAsLargeAsTheModelClosesNothing) {
  BRep_Builder builder;
  TopoDS_Wire wire;
  builder.MakeWire(wire);
  const TopoDS_Edge arc = BRepBuilderAPI_MakeEdge(gp_Circ(gp_Ax2({0, 0, 0}, {0, 0, 1}), 1), 0, pi);
  for (const TopoDS_Vertex& v : {TopExp::FirstVertex(arc), TopExp::LastVertex(arc)})
    builder.UpdateVertex(v, 1e100);
  builder.Add(wire, arc);
  TopoDS_Face face;
  builder.MakeFace(face, new Geom_Plane(gp_Pln(gp_Ax3({0, 0, 0}, {0, 0, 1}))), 1e-7);
  builder.Add(face, wire);
  const ModelMesh result = mesh(face, 0.3);
  EXPECT_EQ(result.faces[0].status, FaceStatus::Failed);
  EXPECT_NE(result.faces[0].reason.find("not closed"), std::string::npos);
}

/// Each of the two arcs passes by its vertex, and would cross the other one before it ends.
TEST(DifficultFaces, CurvesThatPassByTheirVerticesEndThere) {
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
  TopoDS_Face face;
  builder.MakeFace(face, new Geom_Plane(gp_Pln(gp_Ax3({0, 0, 0}, {0, 0, 1}))), 1e-7);
  builder.Add(face, wire);
  const double lens = 2 * (std::acos(0.5) - 0.5 * std::sqrt(0.75));
  expectComplete(mesh(face, 0.1), lens);
}

/// A seam as two edges, each with vertices of its own.
TEST(DifficultFaces, ASphereWithTwoEdgesAlongItsSeamIsClosed) {
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
TEST(DifficultFaces, CurvesInParametersThatRunElsewhereAreFoundAnew) {
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

TEST(DifficultFaces, AGapBeyondTheToleranceIsNamed) {
  BRep_Builder builder;
  TopoDS_Wire wire;
  builder.MakeWire(wire);
  builder.Add(wire, BRepBuilderAPI_MakeEdge(gp_Pnt(0, 0, 0), gp_Pnt(1, 0, 0)).Edge());
  builder.Add(wire, BRepBuilderAPI_MakeEdge(gp_Pnt(1, 0.1, 0), gp_Pnt(0, 1, 0)).Edge());
  TopoDS_Face face;
  builder.MakeFace(face, new Geom_Plane(gp_Pln(gp_Ax3({0, 0, 0}, {0, 0, 1}))), 1e-7);
  builder.Add(face, wire);
  const ModelMesh result = mesh(face, 0.3);
  EXPECT_EQ(result.faces[0].status, FaceStatus::Failed);
  EXPECT_NE(result.faces[0].reason.find("not closed"), std::string::npos);
  EXPECT_NE(result.faces[0].reason.find("ends at (1, 0, 0)"), std::string::npos);
}

std::size_t crossingsOf(const ModelMesh& mesh) {
  return elementCrossings(mesh,
                          [](std::size_t count, const auto& work) {
                            for (std::size_t i = 0; i < count; ++i) work(i);
                          })
      .size();
}

/// Chords of the wanted length of the two circles cross between their ends, and the elements with
/// them.
TEST(DifficultFaces, AThinBentWallIsMeshedSoFinelyThatItsSidesDoNotCross) {
  const TopoDS_Shape outer = BRepPrimAPI_MakeSphere(1.008, 0, pi / 2, pi / 2).Shape();
  const TopoDS_Shape wall =
      BRepAlgoAPI_Cut(outer, BRepPrimAPI_MakeSphere(1, 0, pi / 2, pi / 2).Shape()).Shape();
  const ModelMesh result = mesh(wall, 0.3);
  expectComplete(result, pi / 2 * (1 + 1.008 * 1.008) + 3 * pi / 4 * (1.008 * 1.008 - 1));
  EXPECT_EQ(crossingsOf(result), 0u);
  EXPECT_TRUE(std::ranges::any_of(result.faces, [](const FaceReport& face) {
    return std::ranges::any_of(face.attempts, [](const std::string& step) {
      return step.find("elements cross") != std::string::npos;
    });
  }));
}

/// Which no size can mend.
TEST(DifficultFaces, FacesThatCrossAreNamed) {
  const auto face = [](std::initializer_list<gp_Pnt> corners) {
    BRepBuilderAPI_MakePolygon polygon;
    for (const gp_Pnt& corner : corners) polygon.Add(corner);
    polygon.Close();
    return BRepBuilderAPI_MakeFace(polygon.Wire()).Face();
  };
  BRepBuilderAPI_Sewing sewing(1e-6);
  sewing.Add(plane({rectangle(0, 0, 1, 1)}));
  sewing.Add(face({{0.5, -1, -1}, {0.5, 2, -1}, {0.5, 2, 1}, {0.5, -1, 1}}));
  // These join the two, so that they are of one piece.
  sewing.Add(face({{0.5, 2, 1}, {0.5, -1, 1}, {1, 1, 0}}));
  sewing.Add(face({{1, 1, 0}, {1, 0, 0}, {0.5, -1, 1}}));
  sewing.Perform();
  const ModelMesh result = mesh(sewing.SewedShape(), 0.4);
  const auto failed = std::ranges::find(result.faces, FaceStatus::Failed, &FaceReport::status);
  ASSERT_NE(failed, result.faces.end());
  EXPECT_NE(failed->reason.find("elements cross those of face"), std::string::npos);
  EXPECT_EQ(std::ranges::count(result.faces, FaceStatus::Complete, &FaceReport::status), 3);
  EXPECT_EQ(crossingsOf(result), 0u);
}

TEST(DifficultFaces, TheSameMeshFromAnyNumberOfThreads) {
  BRepBuilderAPI_MakeWire inner(TopoDS::Edge(circle(1).Reversed()));
  const TopoDS_Face ring = plane({BRepBuilderAPI_MakeWire(circle(1.005)).Wire(), inner.Wire()});
  const Model solid = testing::modelOf(BRepPrimAPI_MakePrism(ring, gp_Vec(0, 0, 0.5)).Shape());
  const AF2Algorithm algorithm(testing::triangleSet());
  ModelMeshingOptions options;
  options.sizes.size = 0.6;
  options.threads = 1;
  const ModelMesh one = meshModel(solid, algorithm, options);
  options.threads = 4;
  const ModelMesh four = meshModel(solid, algorithm, options);
  EXPECT_EQ(one.vertices, four.vertices);
  EXPECT_EQ(one.elements, four.elements);
}

}  // namespace
}  // namespace af2::geometry
