#include "geometry/occ/surfaces/face_surface.h"

#include <gtest/gtest.h>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepTools.hxx>
#include <BRep_Builder.hxx>
#include <Geom_BezierSurface.hxx>
#include <Geom_Circle.hxx>
#include <Geom_CylindricalSurface.hxx>
#include <Geom_Ellipse.hxx>
#include <Geom_Line.hxx>
#include <Geom_SurfaceOfLinearExtrusion.hxx>
#include <Geom_SurfaceOfRevolution.hxx>
#include <TColgp_Array2OfPnt.hxx>
#include <gp.hxx>
#include <limits>
#include <numbers>

#include "engine/base/error.h"
#include "tests/geometry/occ/meshing.h"
#include "tests/geometry/occ/shapes.h"
#include "tests/support/model_mesh.h"

namespace af2::geometry {
namespace {

/// For each face: the closed forms agree with OpenCASCADE on points, normals and curvature.
void expectClosedFormsAgree(const Model& model) {
  for (int id = 1; id <= model.faceCount(); ++id) {
    const TopoDS_Face face = model.shape().face(id);
    const FaceSurface surface(face);
    double u1, u2, v1, v2;
    BRepTools::UVBounds(face, u1, u2, v1, v2);
    for (const double s : {0.1, 0.37, 0.8}) {
      for (const double t : {0.2, 0.55, 0.9}) {
        const SurfacePoint there =
            surface.inOccParameters().pointAt(u1 + s * (u2 - u1), v1 + t * (v2 - v1));
        const SurfacePoint here = surface.pointAt(there.position, there.u, there.v);
        EXPECT_LT(distance(here.normal, there.normal), 1e-12) << model.surfaceType(id);
        if (surface.isPlane()) continue;
        EXPECT_NEAR(surface.radiiAt(here).smallest,
                    surface.inOccParameters().radiiAt(there.u, there.v).smallest, 1e-6)
            << model.surfaceType(id);
      }
    }
  }
}

TopoDS_Face extrudedEllipse(double a, double b) {
  const Handle(Geom_Surface) surface =
      new Geom_SurfaceOfLinearExtrusion(new Geom_Ellipse(gp_Ax2(), a, b), gp_Dir(0, 0, 1));
  return BRepBuilderAPI_MakeFace(surface, 0.0, 2 * std::numbers::pi, 0.0, 3.0, 1e-7).Face();
}

TEST(FaceSurface, KnowsTheRadiusOfACrease) {
  const FaceSurface flattened(extrudedEllipse(2, 0.1));
  EXPECT_NEAR(flattened.creaseRadius(), 0.1 * 0.1 / 2, 0.002);
  EXPECT_NEAR(flattened.breadth(), 8, 0.3);
}

/// There the surface turns at one place, or all around.
TEST(FaceSurface, TakesNeitherTipsNorTubesForCreases) {
  const FaceSurface tube(extrudedEllipse(1, 1));
  EXPECT_NEAR(tube.creaseRadius(), 1, 0.1);
  const Handle(Geom_Curve) throughAxis = new Geom_Line(gp_Pnt(1, 0, 0), gp_Dir(-1, 0, 1));
  const Handle(Geom_Surface) twoCones =
      new Geom_SurfaceOfRevolution(throughAxis, gp_Ax1({0, 0, 0}, {0, 0, 1}));
  const FaceSurface tip(BRepBuilderAPI_MakeFace(twoCones, 0.0, 1.5, 0.0, 2.8, 1e-7).Face());
  EXPECT_GT(tip.creaseRadius(), 0.02);
}

/// x = u^3: full steps from near u = 0 run away.
TEST(FaceSurface, IsFoundBesideSingularParameters) {
  TColgp_Array2OfPnt poles(1, 4, 1, 2);
  for (int j = 1; j <= 2; ++j)
    for (int i = 1; i <= 4; ++i) poles(i, j) = gp_Pnt(i == 4 ? 1 : 0, j - 1, 0);
  const FaceSurface surface(BRepBuilderAPI_MakeFace(new Geom_BezierSurface(poles), 1e-7).Face());
  const auto& general = surface.inOccParameters();
  const SurfacePoint from = general.pointAt(0.05, 0.5), to = general.pointAt(0.06, 0.5);
  for (const double x : {0.001, 0.01, 0.1, 0.9}) {
    const auto found = general.hit({{x, 0.4, 1}, {0, 0, 1}, {1, 0, 0}, {0, 1, 0}, from, to, 0.1});
    ASSERT_TRUE(found) << x;
    EXPECT_LT(distance(found->position, {x, 0.4, 0}), 1e-3);
  }
}

TEST(FaceSurface, AgreesWithOpenCascade) {
  expectClosedFormsAgree(testing::box(1, 2, 3));
  expectClosedFormsAgree(testing::cylinder(2, 3));
  expectClosedFormsAgree(testing::cone(2, 0, 3));
  expectClosedFormsAgree(testing::cone(1, 2, 3));
  expectClosedFormsAgree(testing::sphere(2));
  expectClosedFormsAgree(testing::torus(3, 1));
}

TEST(FaceSurface, RefusesValuesThatAreNotNumbers) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  TopoDS_Face face;
  BRep_Builder().MakeFace(face, new Geom_CylindricalSurface(gp_Ax3(), nan), 1e-7);
  EXPECT_THROW(FaceSurface{face}, GeometryError);
}

TEST(FaceSurface, FlipsTheNormalsOfReversedFaces) {
  expectClosedFormsAgree(testing::modelOf(BRepPrimAPI_MakeSphere(2).Shape().Reversed()));
  expectClosedFormsAgree(testing::modelOf(BRepPrimAPI_MakeCone(2, 1, 3).Shape().Reversed()));
}

/// A face over the whole of a Bezier surface with two by two poles.
TopoDS_Face bilinear(const gp_Pnt& p00, const gp_Pnt& p10, const gp_Pnt& p01, const gp_Pnt& p11) {
  const gp_Pnt rows[] = {p00, p01, p10, p11};
  const TColgp_Array2OfPnt poles(rows[0], 1, 2, 1, 2);
  return BRepBuilderAPI_MakeFace(new Geom_BezierSurface(poles), 1e-7);
}

TEST(FaceSurface, TakesWhatIsSweptWithinAPlaneForOne) {
  const Handle(Geom_Line) line = new Geom_Line(gp_Pnt(0, 0, 1), gp_Dir(1, 0, 0));
  const Handle(Geom_Surface) extruded = new Geom_SurfaceOfLinearExtrusion(line, gp_Dir(1, 2, 0));
  const Handle(Geom_Surface) disc = new Geom_SurfaceOfRevolution(line, gp::OZ());
  const Handle(Geom_Surface) tube =
      new Geom_SurfaceOfLinearExtrusion(new Geom_Circle(gp::XOY(), 1), gp_Dir(0, 0, 1));
  for (const auto& surface : {extruded, disc})
    EXPECT_TRUE(FaceSurface(BRepBuilderAPI_MakeFace(surface, 0, 2, 0, 2, 1e-7).Face()).isPlane());
  EXPECT_FALSE(FaceSurface(BRepBuilderAPI_MakeFace(tube, 0, 2, 0, 2, 1e-7).Face()).isPlane());
}

TEST(FaceSurface, OfADiscThatWasRevolvedIsMeshedAsAPlaneWithAllItsArea) {
  const Handle(Geom_Surface) disc =
      new Geom_SurfaceOfRevolution(new Geom_Line(gp::Origin(), gp::DX()), gp::OZ());
  const double turn = 2 * std::numbers::pi;
  testing::expectComplete(
      testing::mesh(BRepBuilderAPI_MakeFace(disc, 0, turn, 0, 1, 1e-7).Face(), 0.1), turn / 2,
      0.01);
}

TEST(FaceSurface, TakesAFlatSplineForAPlane) {
  EXPECT_TRUE(FaceSurface(bilinear({0, 0, 1}, {2, 0, 1}, {0, 1, 1}, {1, 1, 1})).isPlane());
  EXPECT_FALSE(FaceSurface(bilinear({0, 0, 1}, {2, 0, 1}, {0, 1, 1}, {1, 1, 1.01})).isPlane());
}

/// A front in the plane does not look above it.
TEST(FaceSurface, DrawsCornersFarBesideAPlaneOntoIt) {
  const FaceSurface plane(bilinear({0, 0, 1}, {2, 0, 1}, {0, 1, 1}, {2, 1, 1}));
  EXPECT_NEAR(plane.boundaryPoint({2, 1, 1.5}, 1, 1).position.z, 1, 1e-12);
  EXPECT_EQ(plane.boundaryPoint({2, 1, 1.000001}, 1, 1).position.z, 1.000001);
}

/// One side of the surface is a thousandth as long as the others, and across their plane.
TEST(FaceSurface, SeesNoTwistsThatAreTooSmallToBeSeen) {
  const FaceSurface surface(bilinear({1, 0, 0}, {1, 0, 0.001}, {0, 0.1, 1}, {0, 0.1, -1}));
  const Point3 tip = surface.boundaryPoint({1, 0, 0}, 0, 0).normal;
  const Point3 base = surface.boundaryPoint({0, 0.1, 1}, 0, 1).normal;
  EXPECT_GT(dot(tip, base), 0.95);
}

TEST(FaceSurface, TellsTubesFromRoundings) {
  const auto bentRadius = [](const TopoDS_Shape& shape) {
    const Model model = testing::modelOf(shape);
    const FaceSurface surface(model.shape().face(1));
    double u1, u2, v1, v2;
    BRepTools::UVBounds(model.shape().face(1), u1, u2, v1, v2);
    return surface.radiiAt(surface.inOccParameters().pointAt((u1 + u2) / 2, (v1 + v2) / 2)).bent;
  };
  EXPECT_DOUBLE_EQ(bentRadius(BRepPrimAPI_MakeSphere(2).Shape()), 2);
  EXPECT_DOUBLE_EQ(bentRadius(BRepPrimAPI_MakeCylinder(2, 1).Shape()), 2);
  EXPECT_TRUE(std::isinf(bentRadius(BRepPrimAPI_MakeCylinder(2, 1, 1.5).Shape())));
  EXPECT_TRUE(std::isinf(bentRadius(BRepPrimAPI_MakeBox(1, 1, 1).Shape())));
  EXPECT_DOUBLE_EQ(bentRadius(BRepPrimAPI_MakeTorus(3, 1).Shape()), 1);
  // A quarter of the tube, all the way round: only the large circles count.
  EXPECT_GT(bentRadius(BRepPrimAPI_MakeTorus(3, 1, 0, 1.5).Shape()), 3);
}

/// What a line or an arc in the plane y = 0 sweeps as it turns about the z axis.
FaceSurface revolved(const Handle(Geom_Curve) & line, double length, double turn) {
  const Handle(Geom_Surface) surface = new Geom_SurfaceOfRevolution(line, gp::OZ());
  return FaceSurface(BRepBuilderAPI_MakeFace(surface, 0, turn, 0, length, 1e-7));
}

TEST(FaceSurface, EndsInASharpTipWhereItIsRevolvedFromTheAxis) {
  const FaceSurface surface = revolved(new Geom_Line({0, 0, 0}, {1, 0, 1}), 2, 5.5);
  const GeneralSurface& parameters = surface.inOccParameters();
  const SurfacePoint near = parameters.pointAt(1, 0.01), away = parameters.pointAt(1, 0.2);
  EXPECT_NEAR(surface.radiiAt(near, 0.2).smallest, surface.radiiAt(away, 0.2).smallest, 1e-9);
  EXPECT_NEAR(surface.radiiAt(near).smallest, 0.01, 1e-9);
  // Seen from its normal, all of the surface around the tip faces the same way.
  const Point3 atTip = surface.boundaryPoint({0, 0, 0}, 0, 0).normal;
  for (const double u : {0.0, 1.0, 2.75, 4.0, 5.5})
    EXPECT_GT(dot(atTip, parameters.normalAt(u, 0.1)), 0.4) << u;
}

TEST(FaceSurface, EndsInNoSharpTipAtThePoleOfADome) {
  const gp_Ax2 frame({0, 0, 0}, {0, -1, 0}, {0, 0, 1});
  const FaceSurface surface = revolved(new Geom_Circle(frame, 0.1), 1.5, 5.5);
  const SurfacePoint near = surface.inOccParameters().pointAt(1, 0.01);
  EXPECT_NEAR(surface.radiiAt(near, 0.2).smallest, 0.1, 1e-9);
}

TEST(DevelopedCone, IsIsometric) {
  for (const Model& model : {testing::cone(1, 0, 2), testing::cone(1, 2, 2)}) {
    const FaceSurface surface(model.shape().face(1));
    const ParametricSurface& flat = *surface.inParameters();
    for (const double s : {-2.0, 0.1, 1.9}) {
      for (const double t : {0.3, 0.8}) {
        const SurfacePoint raw = surface.inOccParameters().pointAt(3 + s, t);
        const SurfacePoint p = surface.boundaryPoint(raw.position, raw.u, raw.v);
        EXPECT_LT(distance(flat.pointAt(p.u, p.v).position, raw.position), 1e-13);
        EXPECT_LT(distance(flat.pointAt(p.u, p.v).normal, raw.normal), 1e-13);
        const auto frame = flat.frameAt(p.u, p.v);
        EXPECT_NEAR(length(frame.du), 1, 1e-13);
        EXPECT_NEAR(dot(frame.du, frame.dv), 0, 1e-13);
        EXPECT_LT(distance(flat.pointAt(p.u + 1e-6, p.v).position, raw.position + 1e-6 * frame.du),
                  1e-11);
        EXPECT_EQ(dot(cross(frame.du, frame.dv), raw.normal) < 0, flat.isFlipped());
      }
    }
  }
}

TEST(GeneralSurface, FindsItsWayBackToParameters) {
  const Model model = testing::torus(3, 1);
  const FaceSurface surface(model.shape().face(1));
  const GeneralSurface& general = surface.inOccParameters();
  double u = 1.1, v = 2.0;
  general.refine(general.frameAt(1.3, 1.7).position, u, v);
  EXPECT_NEAR(u, 1.3, 1e-10);
  EXPECT_NEAR(v, 1.7, 1e-10);
}

TEST(GeneralSurface, IsMetByALineNearItsSeed) {
  const Model model = testing::torus(3, 1);
  const FaceSurface surface(model.shape().face(1));
  const GeneralSurface& general = surface.inOccParameters();
  const MeanNormalChartMaker<GeneralSurface> charts(general);
  const SurfacePoint from = general.pointAt(6.2, 0.1), to = general.pointAt(0.05, 0.1);
  const auto chart = charts.makeLocalTransform(from, to, distance(from.position, to.position));
  for (const Point2 p : {Point2{0.5, 0.8}, Point2{-0.3, 0.5}, Point2{1.5, 1}}) {
    const auto hit = chart->transformToSurface(p);
    ASSERT_TRUE(hit);
    EXPECT_LT(distance(chart->transformFromSurface(*hit).position, p), 0.01);
    EXPECT_LT(distance(general.frameAt(hit->u, hit->v).position, hit->position), 1e-14);
  }
}

}  // namespace
}  // namespace af2::geometry
