#include "geometry/occ/faces/surface_faults.h"

#include <gtest/gtest.h>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRep_Builder.hxx>
#include <Geom_BezierCurve.hxx>
#include <Geom_Circle.hxx>
#include <Geom_Hyperbola.hxx>
#include <Geom_Line.hxx>
#include <Geom_SurfaceOfLinearExtrusion.hxx>
#include <Geom_SurfaceOfRevolution.hxx>
#include <TColgp_Array1OfPnt.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Shell.hxx>
#include <gp_Circ.hxx>

#include <cmath>

#include "geometry/io/report.h"
#include "geometry/occ/faces/fault_reasons.h"
#include "tests/geometry/occ/curves.h"
#include "tests/geometry/occ/meshing.h"

namespace af2::geometry {
namespace {

constexpr double kHeight = 2;

TopoDS_Face extrusion(const Handle(Geom_BSplineCurve) & curve) {
  return BRepBuilderAPI_MakeFace(new Geom_SurfaceOfLinearExtrusion(curve, gp::DZ()),
                                 curve->FirstParameter(), curve->LastParameter(), 0, kHeight, 1e-6);
}

/// Above the curve (t^3 - 3 t, t^2), which crosses itself at (0, 3).
TopoDS_Face loop() {
  std::vector<gp_Pnt> points;
  for (int i = -11; i <= 11; ++i) {
    const double t = 0.2 * i;
    points.emplace_back(t * t * t - 3 * t, t * t, 0);
  }
  return extrusion(testing::splineThrough(points));
}

/// Turns back at x = 2 and again at x = 1.5.
TopoDS_Face fold() {
  return extrusion(testing::polyline({{0, 0, 0}, {2, 0, 0}, {1.5, 0.05, 0}, {4, 0.1, 0}}));
}

TEST(SurfaceFault, IsACrossingWhereASurfaceCrossesItself) {
  const auto fault = surfaceFault(loop(), 0.5);
  ASSERT_TRUE(fault);
  EXPECT_EQ(fault->kind, SurfaceFault::Kind::Crossing);
  EXPECT_NEAR(fault->place.x, 0, 1e-9);
  EXPECT_NEAR(fault->place.y, 3, 1e-3);
  EXPECT_TRUE(textOf(*fault).starts_with("in the model itself its surface crosses itself at ("));
}

TEST(SurfaceFault, IsAFoldWhereASurfaceTurnsBackAndForth) {
  const auto fault = surfaceFault(fold(), 0.5);
  ASSERT_TRUE(fault);
  EXPECT_EQ(fault->kind, SurfaceFault::Kind::Fold);
  EXPECT_NEAR(fault->place.x, 2, 0.05);
  EXPECT_NEAR(fault->other.x, 1.5, 0.05);
  EXPECT_NE(textOf(*fault).find("and back again at ("), std::string::npos);
}

/// Of radius 0.7, bent around an axis 0.625 away from its middle.
TopoDS_Face bentPipe() {
  const gp_Circ profile(gp_Ax2({0.625, 0, 0}, gp::DY()), 0.7);
  return BRepBuilderAPI_MakeFace(new Geom_SurfaceOfRevolution(new Geom_Circle(profile), gp::OZ()),
                                 0, 1.5, 0, 6.28, 1e-6);
}

TEST(SurfaceFault, IsAPinchWhereAProfileCrossesItsAxis) {
  const auto fault = surfaceFault(bentPipe(), 0.2);
  ASSERT_TRUE(fault);
  EXPECT_EQ(fault->kind, SurfaceFault::Kind::Pinch);
  EXPECT_NEAR(std::hypot(fault->place.x, fault->place.y), 0, 1e-4);
  EXPECT_NEAR(std::abs(fault->place.z), std::sqrt(0.7 * 0.7 - 0.625 * 0.625), 1e-3);
}

/// A hundredth of the curve before its end on the axis.
TEST(SurfaceFault, IsAPinchAlsoCloseToTheEndOfAProfile) {
  TColgp_Array1OfPnt poles(1, 4);
  poles(1) = {1, 0, 0};
  poles(2) = {1, 0, 1};
  poles(3) = {-0.01, 0, 1.8};
  poles(4) = {0, 0, 2};
  const TopoDS_Face vase = BRepBuilderAPI_MakeFace(
      new Geom_SurfaceOfRevolution(new Geom_BezierCurve(poles), gp::OZ()), 1e-6);
  const auto fault = surfaceFault(vase, 0.02);
  ASSERT_TRUE(fault);
  EXPECT_EQ(fault->kind, SurfaceFault::Kind::Pinch);
  EXPECT_NEAR(std::hypot(fault->place.x, fault->place.y), 0, 1e-5);
  EXPECT_GT(fault->place.z, 1.99);
}

/// A line extruded along itself.
TopoDS_Face withoutArea() {
  return BRepBuilderAPI_MakeFace(
      new Geom_SurfaceOfLinearExtrusion(new Geom_Line(gp::OZ()), gp::DZ()), 0, 2, 0, 1, 1e-6);
}

TEST(SurfaceFault, IsALineWithoutArea) {
  const auto fault = surfaceFault(withoutArea(), 0.2);
  ASSERT_TRUE(fault);
  EXPECT_EQ(fault->kind, SurfaceFault::Kind::NoArea);
  EXPECT_NEAR(fault->place.z, 1.5, 1e-9);
  EXPECT_EQ(textOf(*fault),
            "in the model itself its surface is a line, without area, through (0, 0, 1.5): delete "
            "the face");
  EXPECT_TRUE(isLine(withoutArea()));
  EXPECT_FALSE(isLine(loop()));
}

TEST(SurfaceFault, ThatIsALineHasNoElements) {
  TopoDS_Shell shell;
  BRep_Builder builder;
  builder.MakeShell(shell);
  builder.Add(shell, testing::plane({testing::rectangle(1, 1, 2, 2)}));
  builder.Add(shell, withoutArea());
  const ModelMesh mesh = testing::mesh(shell, 0.2);
  EXPECT_EQ(statusOf(mesh), RunStatus::Complete);
  EXPECT_GT(mesh.faces.at(0).elements, 0u);
  EXPECT_EQ(mesh.faces.at(1).elements, 0u);
  EXPECT_EQ(mesh.faces.at(1).reason, "is a line, without area, so it has no elements");
}

TEST(SurfaceFault, IsNoneOnSoundSurfaces) {
  EXPECT_FALSE(surfaceFault(
      extrusion(testing::splineThrough({{-3, 0, 0}, {-1, 1, 0}, {1, -1, 0}, {3, 0, 0}})),
      0.5));  // a wave
  EXPECT_FALSE(surfaceFault(extrusion(testing::polyline({{0, 0, 0}, {3, 0, 0}, {0, 0.1, 0}})),
                            0.5));  // a tip
  for (const Model& model : {testing::sphere(1), testing::torus(2, 0.5), testing::cylinder(1, 2)})
    EXPECT_FALSE(surfaceFault(model.shape().face(1), 0.2));
}

TEST(SurfaceFault, IsNoneWithoutASurface) {
  TopoDS_Face face;
  BRep_Builder().MakeFace(face);
  EXPECT_FALSE(surfaceFault(face, 0.5));
  EXPECT_FALSE(surfaceFault(testing::modelOf(face).shape(), 1, 0.5));
}

/// A hyperbola far from its vertex has coordinates larger than any number.
TEST(SurfaceFault, IsNoneWhereASurfaceCannotBeEvaluated) {
  const gp_Hypr profile(gp_Ax2(gp_Pnt(), gp::DY(), gp::DX()), 1, 1);
  TopoDS_Face face;
  BRep_Builder().MakeFace(face, new Geom_SurfaceOfRevolution(new Geom_Hyperbola(profile), gp::OX()),
                          1e-6);
  EXPECT_FALSE(surfaceFault(testing::modelOf(face).shape(), 1, 0.5));
  EXPECT_EQ(testing::mesh(face, 0.5).faces.at(0).status, FaceStatus::Failed);
}

TEST(SurfaceFault, IsNoneOutsideTheFace) {
  const TopoDS_Face whole = loop();
  double u1 = 0, u2 = 0, v1 = 0, v2 = 0;
  BRep_Tool::Surface(whole)->Bounds(u1, u2, v1, v2);
  const TopoDS_Face half =
      BRepBuilderAPI_MakeFace(BRep_Tool::Surface(whole), u1, (u1 + u2) / 2, 0, kHeight, 1e-6);
  EXPECT_FALSE(surfaceFault(half, 0.5));
}

/// A triangle with a tiny angle on face 1.
ModelMesh needle() {
  ModelMesh mesh;
  mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {1, 0.001, 0}};
  Element element;
  element.corners = {VertexId(0), VertexId(1), VertexId(2), VertexId()};
  mesh.elements = {element};
  mesh.face = {1};
  mesh.faces.resize(1);
  mesh.faces[0].id = 1;
  mesh.faces[0].surfaceType = "extrusion";
  return mesh;
}

TEST(SurfaceFault, IsToldOfFacesThatFailed) {
  const Model model = testing::modelOf(loop());
  ModelMesh mesh = needle();
  mesh.faces[0].status = FaceStatus::Failed;
  mesh.faces[0].reason = "stuck";
  tellOfFaults(model.shape(), 0.5, mesh);
  EXPECT_TRUE(mesh.faces[0].reason.starts_with("stuck; in the model itself its surface crosses"))
      << mesh.faces[0].reason;
  EXPECT_EQ(mesh.faces[0].cause, FailureCause::Model);
  EXPECT_TRUE(mesh.notes.empty());
}

/// How often a face is meshed that fails, at a size of 0.2.
int runsOf(const TopoDS_Face& face) {
  int runs = 0;
  MeshingOptions options = testing::ofSize(0.2);
  options.observer = [&](int) {
    ++runs;
    return nullptr;
  };
  const ModelMesh mesh = testing::mesh(testing::modelOf(face), options);
  EXPECT_EQ(mesh.faces[0].status, FaceStatus::Failed);
  return runs;
}

TEST(SurfaceFault, IsNotMetWithShorterEdges) {
  EXPECT_LE(runsOf(bentPipe()), 4);
  EXPECT_LE(runsOf(loop()), 4);
}

TEST(SurfaceFault, IsToldOfCompleteFacesWithNeedlesThatWereHardToMesh) {
  const Model model = testing::modelOf(loop());
  ModelMesh mesh = needle();
  tellOfFaults(model.shape(), 0.5, mesh);
  EXPECT_TRUE(mesh.notes.empty());
  mesh.faces[0].attempts = {"shorter edges"};
  tellOfFaults(model.shape(), 0.5, mesh);
  ASSERT_EQ(mesh.notes.size(), 1u);
  EXPECT_TRUE(mesh.notes[0].starts_with(
      "face 1 has angles below half a degree: in the model itself its surface crosses itself"))
      << mesh.notes[0];
}

TEST(SurfaceFault, IsNoneWhereATipIsToldOfInstead) {
  const ModelMesh mesh = testing::mesh(testing::cone(0.005, 0, 3), 0.4);
  testing::expectComplete(mesh);
  ASSERT_FALSE(mesh.notes.empty());
  EXPECT_EQ(mesh.notes[0],
            "face 1 has angles below half a degree: it ends in a tip of 0.19 degrees at (0, 0, 3)");
}

}  // namespace
}  // namespace af2::geometry
