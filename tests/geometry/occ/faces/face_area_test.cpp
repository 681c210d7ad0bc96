#include "geometry/occ/faces/face_area.h"

#include <gtest/gtest.h>
#include <BRepAlgoAPI_Cut.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_NurbsConvert.hxx>
#include <BRepGProp.hxx>
#include <BRepPrimAPI_MakeRevol.hxx>
#include <BRep_Builder.hxx>
#include <GProp_GProps.hxx>
#include <Geom_CylindricalSurface.hxx>
#include <Precision.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <gp_Pln.hxx>

#include <cmath>
#include <numbers>

#include "tests/geometry/occ/shapes.h"

namespace af2::geometry {
namespace {

using std::numbers::pi;

double sumOfAreas(const Model& model) {
  double sum = 0;
  for (int id = 1; id <= model.faceCount(); ++id) sum += areaOf(model.shape(), id);
  return sum;
}

/// Of each face, held against OpenCASCADE's own integration.
void expectAreasOfOpenCascade(const TopoDS_Shape& shape) {
  const Model model = testing::modelOf(shape);
  for (int id = 1; id <= model.faceCount(); ++id) {
    GProp_GProps properties;
    BRepGProp::SurfaceProperties(model.shape().face(id), properties, 1e-9);
    const double expected = std::abs(properties.Mass());
    EXPECT_NEAR(areaOf(model.shape(), id), expected, 2e-6 * expected)
        << "face " << id << ", " << model.surfaceType(id);
  }
}

TEST(FaceArea, OfSimpleShapesIsThatOfTheFormulas) {
  EXPECT_NEAR(sumOfAreas(testing::box(1, 2, 3)), 22, 1e-12);
  EXPECT_NEAR(sumOfAreas(testing::cylinder(2, 3)), 20 * pi, 1e-8);
  EXPECT_NEAR(sumOfAreas(testing::sphere(2)), 16 * pi, 1e-8);
  EXPECT_NEAR(sumOfAreas(testing::torus(3, 1)), 12 * pi * pi, 1e-8);
  EXPECT_NEAR(sumOfAreas(testing::cone(3, 0, 4)), 24 * pi, 1e-8);
}

TEST(FaceArea, OfTrimmedFacesIsThatOfOpenCascade) {
  expectAreasOfOpenCascade(testing::drilledBlock());
  expectAreasOfOpenCascade(
      BRepAlgoAPI_Cut(BRepPrimAPI_MakeSphere(2).Shape(), testing::drilledBlock()));
  expectAreasOfOpenCascade(
      BRepAlgoAPI_Cut(BRepPrimAPI_MakeTorus(3, 1).Shape(), testing::drilledBlock()));
}

TEST(FaceArea, OfSplinesIsThatOfOpenCascade) {
  expectAreasOfOpenCascade(BRepBuilderAPI_NurbsConvert(testing::drilledBlock()).Shape());
  expectAreasOfOpenCascade(
      BRepBuilderAPI_NurbsConvert(BRepPrimAPI_MakeTorus(3, 1, 1.5).Shape()).Shape());
}

TEST(FaceArea, OfSurfacesWithoutClosedFormIsThatOfOpenCascade) {
  // A spindle torus, and a square revolved around an axis across it.
  expectAreasOfOpenCascade(BRepPrimAPI_MakeTorus(1, 1.5, -1, 1).Shape());
  const TopoDS_Shape square =
      BRepBuilderAPI_NurbsConvert(
          BRepBuilderAPI_MakeFace(gp_Pln(gp_Pnt(2, 0, 0), gp_Dir(0, 1, 0)), -1, 1, -1, 1).Shape())
          .Shape();
  expectAreasOfOpenCascade(
      BRepPrimAPI_MakeRevol(square, gp_Ax1(gp_Pnt(0, 0, 0), gp_Dir(0.3, 0, 1)), 2.0).Shape());
}

/// The face of a cylinder from angle 0 to `turn`, whose edges are said to be exact to a tolerance.
TopoDS_Face strip(double turn, double tolerance) {
  const TopoDS_Face face = BRepBuilderAPI_MakeFace(new Geom_CylindricalSurface(gp_Ax3(), 1), 0,
                                                   turn, 0, 1, Precision::Confusion());
  for (TopExp_Explorer edges(face, TopAbs_EDGE); edges.More(); edges.Next())
    BRep_Builder().UpdateEdge(TopoDS::Edge(edges.Current()), tolerance);
  return face;
}

TEST(FaceArea, CannotBeToldWhereFacesAreNarrowerThanTheirEdgesAreExact) {
  EXPECT_NEAR(sumOfAreas(testing::modelOf(strip(1e-3, 1e-5))), 1e-3, 1e-9);
  EXPECT_EQ(sumOfAreas(testing::modelOf(strip(1e-3, 1e-3))), 0);
}

TEST(FaceArea, DoesNotDependOnTheOrientation) {
  const TopoDS_Shape sphere = BRepPrimAPI_MakeSphere(2).Shape();
  EXPECT_DOUBLE_EQ(sumOfAreas(testing::modelOf(sphere.Reversed())),
                   sumOfAreas(testing::modelOf(sphere)));
}

}  // namespace
}  // namespace af2::geometry
