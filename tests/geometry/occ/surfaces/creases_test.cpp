// Faces that turn sharply inside, along lines that are no edges.
#include "geometry/occ/surfaces/creases.h"

#include <gtest/gtest.h>
#include <BRepAlgoAPI_Cut.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepBuilderAPI_NurbsConvert.hxx>
#include <BRepGProp.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <BRepPrimAPI_MakeRevol.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <GC_MakeArcOfCircle.hxx>
#include <GC_MakeSegment.hxx>
#include <GProp_GProps.hxx>
#include <GeomConvert.hxx>
#include <GeomConvert_CompCurveToBSplineCurve.hxx>
#include <GeomFill.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Geom_Circle.hxx>
#include <Geom_TrimmedCurve.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColgp_Array1OfPnt.hxx>
#include <TColgp_Array2OfPnt.hxx>

#include <cmath>
#include <numbers>
#include <set>

#include "geometry/occ/faces/face_area.h"
#include "geometry/occ/run/creased_shape.h"
#include "tests/geometry/occ/curves.h"
#include "tests/geometry/occ/meshing.h"
#include "tests/support/model_mesh.h"

namespace af2::geometry {
namespace {

using testing::expectComplete;
using testing::mesh;
using testing::modelOf;
using testing::ofSize;
using testing::polyline;
using testing::uniform;

/// A roof of two planes in one face, with the ridge at x = 0.
TopoDS_Shape roof() {
  return BRepPrimAPI_MakePrism(
             BRepBuilderAPI_MakeEdge(polyline({{-1, 0, 0}, {0, 0, 0.8}, {1, 0, 0}})).Edge(),
             gp_Vec(0, 2, 0))
      .Shape();
}

double areaOf(const TopoDS_Shape& shape) {
  GProp_GProps properties;
  BRepGProp::SurfaceProperties(shape, properties);
  return properties.Mass();
}

std::size_t segmentsAlongCreases(const ModelMesh& mesh, const Model& model) {
  return static_cast<std::size_t>(std::ranges::count_if(
      mesh.segments, [&](const EdgeSegment& s) { return s.edge > model.edgeCount(); }));
}

TEST(Creases, AtKinksOfSplinesAreKept) {
  const TopoDS_Shape shape = roof();
  for (const TopoDS_Shape& each :
       {shape, TopoDS_Shape(BRepBuilderAPI_NurbsConvert(shape).Shape())}) {
    const Model model = modelOf(each);
    const ModelMesh result = mesh(model, 0.21);
    expectComplete(result, areaOf(each), 1e-9);  // flat on both sides
    EXPECT_GE(segmentsAlongCreases(result, model), 9u);
    EXPECT_EQ(result.faces.size(), 1u);
    ASSERT_FALSE(result.faces[0].attempts.empty());
    EXPECT_EQ(result.faces[0].attempts[0].find("turns sharply inside"), 0u);
  }
}

TEST(Creases, InBothDirectionsCross) {
  TColgp_Array2OfPnt poles(1, 3, 1, 3);
  for (int i = -1; i <= 1; ++i)
    for (int j = -1; j <= 1; ++j)
      poles.SetValue(i + 2, j + 2, gp_Pnt(i, j, -0.6 * std::abs(i) - 0.7 * std::abs(j)));
  TColStd_Array1OfReal knots(1, 3);
  TColStd_Array1OfInteger uses(1, 3);
  for (int i = 1; i <= 3; ++i) knots(i) = i, uses(i) = i == 2 ? 1 : 2;
  const Handle(Geom_Surface) surface =
      new Geom_BSplineSurface(poles, knots, knots, uses, uses, 1, 1);
  const TopoDS_Face face = BRepBuilderAPI_MakeFace(surface, 1e-7).Face();
  expectComplete(mesh(face, 0.3), areaOf(face), 1e-9);
}

/// Two planks that meet all but flat at one end of their joint, and at an edge at the other one.
TopoDS_Face fadingRidge(double turn) {
  TColgp_Array2OfPnt poles(1, 3, 1, 4);
  for (int i = -1; i <= 1; ++i)
    for (int j = 0; j < 4; ++j)
      poles.SetValue(i + 2, j + 1, gp_Pnt(j, i, j < 2 ? 0 : turn * (j - 1) * std::abs(i)));
  TColStd_Array1OfReal across(1, 3), along(1, 2);
  TColStd_Array1OfInteger atAcross(1, 3), atAlong(1, 2);
  for (int i = 1; i <= 3; ++i) across(i) = i, atAcross(i) = i == 2 ? 1 : 2;
  for (int i = 1; i <= 2; ++i) along(i) = i, atAlong(i) = 4;
  return BRepBuilderAPI_MakeFace(
             new Geom_BSplineSurface(poles, across, along, atAcross, atAlong, 1, 3), 1e-7)
      .Face();
}

TEST(Creases, ThatFadeOutAreKept) {
  // 50 degrees at one end; less than 30 in most of the face.
  const TopoDS_Face face = fadingRidge(0.23);
  const Model model = modelOf(face);
  const ModelMesh result = mesh(model, 0.2);
  expectComplete(result, areaOf(face), 0.01);
  EXPECT_GE(segmentsAlongCreases(result, model), 12u);
}

/// From a circle to the same one half a turn on: two cones, tip to tip, in one face.
TopoDS_Face hourglass(double radius) {
  const auto circle = [&](double height, double towards) {
    return GeomConvert::CurveToBSplineCurve(
        new Geom_Circle(gp_Ax2({0, 0, height}, {0, 0, 1}, {towards, 0, 0}), radius));
  };
  return BRepBuilderAPI_MakeFace(GeomFill::Surface(circle(-1, 1), circle(1, -1)), 1e-7).Face();
}

TEST(Creases, AreWhereAFacePinchesToAPoint) {
  for (const double size : {0.15, 0.4}) {
    const ModelMesh result = mesh(hourglass(1.2), size);
    expectComplete(result, 2 * std::numbers::pi * 1.2 * std::hypot(1, 1.2), 0.05);
    const auto atTip = [](const Point3& p) { return length(p) < 1e-9; };
    EXPECT_EQ(std::ranges::count_if(result.vertices, atTip), 1);
  }
}

TEST(Creases, GoOnBeyondHoles) {
  const TopoDS_Shape hole =
      BRepPrimAPI_MakeCylinder(gp_Ax2({0.1, 1, -1}, {0, 0, 1}), 0.4, 3).Shape();
  const TopoDS_Shape shape = BRepAlgoAPI_Cut(roof(), hole).Shape();
  const Model model = modelOf(shape);
  const ModelMesh result = mesh(model, 0.15);
  expectComplete(result, areaOf(shape), 0.01);
  std::set<int> edges;
  for (const EdgeSegment& segment : result.segments)
    if (segment.edge > model.edgeCount()) edges.insert(segment.edge);
  EXPECT_EQ(edges.size(), 2u);
}

/// A side of a ring that is closed both ways; three of its four kinks are inside.
TEST(Creases, OfClosedFacesAreKept) {
  const Handle(Geom_Curve) square =
      polyline({{2, 0, 0}, {3, 0, 0}, {3, 0, 1}, {2, 0, 1}, {2, 0, 0}});
  const TopoDS_Wire wire = BRepBuilderAPI_MakeWire(BRepBuilderAPI_MakeEdge(square).Edge());
  const TopoDS_Shape ring = BRepPrimAPI_MakeRevol(BRepBuilderAPI_MakeFace(wire, true).Face(),
                                                  gp_Ax1({0, 0, 0}, {0, 0, 1}))
                                .Shape();
  const Model model = modelOf(ring);
  const ModelMesh result = mesh(model, 0.35);
  expectComplete(result, areaOf(ring), 0.01);
  for (const Point3& p : result.vertices) {
    const double r = std::hypot(p.x, p.y);
    const double off =
        std::min({std::abs(r - 2), std::abs(r - 3), std::abs(p.z), std::abs(p.z - 1)});
    EXPECT_LT(off, 1e-6);
  }
}

/// A plane polygon with rounded corners, its outline one spline.
TopoDS_Face roundedPolygon(const std::vector<gp_Pnt>& corners, double radius) {
  const std::size_t n = corners.size();
  std::vector<gp_Pnt> starts, ends;  // of the straight pieces after and before each corner
  for (std::size_t i = 0; i < n; ++i) {
    const gp_Vec in(corners[(i + n - 1) % n], corners[i]), out(corners[i], corners[(i + 1) % n]);
    const double cut = radius * std::tan(in.Angle(out) / 2);
    ends.push_back(corners[i].Translated(-cut * in.Normalized()));
    starts.push_back(corners[i].Translated(cut * out.Normalized()));
  }
  GeomConvert_CompCurveToBSplineCurve joined(Convert_QuasiAngular);
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t next = (i + 1) % n;
    joined.Add(GC_MakeSegment(starts[i], ends[next]).Value(), 1e-7, true);
    joined.Add(GC_MakeArcOfCircle(ends[next], gp_Vec(starts[i], ends[next]), starts[next]).Value(),
               radius / 100, true);
  }
  const TopoDS_Wire wire =
      BRepBuilderAPI_MakeWire(BRepBuilderAPI_MakeEdge(joined.BSplineCurve()).Edge());
  return BRepBuilderAPI_MakeFace(wire, true).Face();
}

/// Its sides are one face.
TopoDS_Shape roundedPrism(double radius) {
  const TopoDS_Face base = roundedPolygon({{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}}, radius);
  return BRepPrimAPI_MakePrism(base, gp_Vec(0, 0, 2)).Shape();
}

double leastAngle(const ModelMesh& mesh) {
  double least = 180;
  for (const Element& element : mesh.elements) {
    const auto c = element.vertices();
    for (std::size_t i = 0; i < c.size(); ++i) {
      const auto at = [&](std::size_t k) { return mesh.vertices[c[(i + k) % c.size()].value]; };
      const Point3 a = unit(at(1) - at(0)), b = unit(at(c.size() - 1) - at(0));
      least = std::min(least, std::acos(std::clamp(dot(a, b), -1.0, 1.0)) * 180 / 3.14159265358979);
    }
  }
  return least;
}

TEST(Creases, WhereTheRadiusIsFarBelowTheSizeAreEdges) {
  const TopoDS_Shape shape = roundedPrism(0.002);
  const Model model = modelOf(shape);
  const ModelMesh result = mesh(model, 0.25);
  expectComplete(result, areaOf(shape), 0.01);
  EXPECT_GT(leastAngle(result), 15);
  EXPECT_GE(segmentsAlongCreases(result, model), 3u * 7u);
}

/// A ring with a section of seven sides, its surface one face: each crease turns by 51 degrees.
/// Elements that followed them would be a hundred times smaller than the others.
TEST(Creases, OfLessThanARadianAreEdges) {
  constexpr double kTurn = 2 * std::numbers::pi;
  std::vector<gp_Pnt> corners;
  for (int i = 0; i < 7; ++i)
    corners.emplace_back(2.6 + std::cos(kTurn * i / 7), 0, std::sin(kTurn * i / 7));
  const TopoDS_Shape ring =
      BRepPrimAPI_MakeRevol(roundedPolygon(corners, 0.003), gp_Ax1({0, 0, 0}, {0, 0, 1})).Shape();
  for (const double turn : {0, 12}) {
    MeshingOptions options = ofSize(0.16);
    options.sizes.elementsPerTurn = turn;
    const Model model = modelOf(ring);
    const ModelMesh result = mesh(model, options);
    expectComplete(result, areaOf(ring), 0.01);
    EXPECT_GT(leastAngle(result), 25);
    EXPECT_LT(result.elements.size(), 15'000u);
    EXPECT_GE(segmentsAlongCreases(result, model), 6u * 60u);
  }
}

/// Extruded between the middles of two roundings, so that the face ends in both.
TopoDS_Shape betweenRoundings(double width) {
  constexpr double kRadius = 0.002;
  const auto arc = [](double x, double from, double to) {
    const auto at = [&](double angle) {
      return gp_Pnt(x + kRadius * std::cos(angle), kRadius * std::sin(angle), 0);
    };
    return GC_MakeArcOfCircle(at(from), at((from + to) / 2), at(to)).Value();
  };
  constexpr double kQuarter = 1.5707963267948966;
  GeomConvert_CompCurveToBSplineCurve joined(Convert_QuasiAngular);
  joined.Add(arc(0, -2 * kQuarter, -kQuarter), kRadius / 100, true);
  joined.Add(GC_MakeSegment(gp_Pnt(0, -kRadius, 0), gp_Pnt(width, -kRadius, 0)).Value(),
             kRadius / 100, true);
  joined.Add(arc(width, -kQuarter, 0), kRadius / 100, true);
  return BRepPrimAPI_MakePrism(BRepBuilderAPI_MakeEdge(joined.BSplineCurve()).Edge(),
                               gp_Vec(0, 0, 2))
      .Shape();
}

TEST(Creases, WhereAFaceEndsInATurnCountForNothing) {
  const TopoDS_Shape shape = betweenRoundings(1);
  const ModelMesh result = mesh(shape, 0.2);
  expectComplete(result, areaOf(shape), 0.01);
  EXPECT_GT(leastAngle(result), 25);
  EXPECT_LT(result.elements.size(), 200u);
}

/// There is nothing but the turns to the shape of such a strip.
TEST(Creases, OfStripsWithRoundedBordersAreTheirShape) {
  const auto isCalmInside = [](double width) {
    const Model model = modelOf(betweenRoundings(width));
    return withCreases(model.sharedShape(), {1}, uniform(0.2), 1, {})->cells.contains(1);
  };
  EXPECT_TRUE(isCalmInside(1));
  EXPECT_FALSE(isCalmInside(0.01));
}

TEST(Creases, AreNoneWhereElementsFollowTheTurn) {
  for (const TopoDS_Shape& shape :
       {roundedPrism(0.2),
        TopoDS_Shape(
            BRepBuilderAPI_NurbsConvert(BRepPrimAPI_MakeTorus(1.0, 0.02).Shape()).Shape())}) {
    const Model model = modelOf(shape);
    const CadSizes sizes = uniform(0.25);
    EXPECT_TRUE(withCreases(model.sharedShape(), {1}, sizes, 1, {})->creaseEdges.empty());
  }
}

TEST(Creases, CutTheAreaOfAFace) {
  const TopoDS_Shape hole =
      BRepPrimAPI_MakeCylinder(gp_Ax2({0.1, 1, -1}, {0, 0, 1}), 0.4, 3).Shape();
  const Model model = modelOf(BRepAlgoAPI_Cut(roof(), hole).Shape());
  const auto shape = withCreases(model.sharedShape(), {1}, uniform(0.2), 1, {});
  const FaceCells& cells = shape->cells.at(1);
  double sum = 0;
  for (const Stretch& u : cells.u)
    for (const Stretch& v : cells.v) sum += areaOf(*shape, 1, u, v);
  EXPECT_NEAR(sum, areaOf(model.shape(), 1), 1e-3);
}

/// Then they are not kept, but the face is.
TEST(Creases, GiveWayToPointsThatAreGiven) {
  const Model model = modelOf(roof());
  MeshingOptions options = ofSize(0.2);
  for (int edge = 1; edge <= model.edgeCount(); ++edge) {
    const ModelMesh whole = mesh(model, 0.2);
    std::vector<Point3> inner;
    for (const EdgeSegment& s : whole.segments)
      if (s.edge == edge) inner.push_back(whole.vertices[s.to.value]);
    if (!inner.empty()) inner.pop_back();
    options.edgePoints[edge] = inner;
  }
  const ModelMesh result = mesh(model, options);
  expectComplete(result);
  EXPECT_EQ(segmentsAlongCreases(result, model), 0u);
}

TEST(Creases, OfSecondOrderHaveTheirMiddlesOnThem) {
  const Model model = modelOf(roof());
  MeshingOptions options = ofSize(0.4);
  options.order = 2;
  const ModelMesh result = mesh(model, options);
  expectComplete(result);
  for (const EdgeSegment& s : result.segments)
    if (s.edge > model.edgeCount()) {
      EXPECT_NEAR(s.middle.z, 0.8, 1e-9);
    }
}

}  // namespace
}  // namespace af2::geometry
