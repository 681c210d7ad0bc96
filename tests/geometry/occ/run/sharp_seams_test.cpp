// Surfaces that come back to themselves at an angle, as a wing at its trailing edge.
#include "geometry/mesh/sharp_seams.h"

#include <gtest/gtest.h>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepGProp.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <BRepPrimAPI_MakeRevol.hxx>
#include <GProp_GProps.hxx>
#include <GeomConvert.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Geom_BezierCurve.hxx>
#include <Geom_RectangularTrimmedSurface.hxx>
#include <Geom_SurfaceOfLinearExtrusion.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColgp_Array1OfPnt.hxx>

#include <cmath>

#include "engine/base/error.h"
#include "geometry/occ/edges/edge_division.h"
#include "geometry/occ/faces/face_mesher.h"
#include "tests/geometry/occ/meshing.h"
#include "tests/support/model_mesh.h"

namespace af2::geometry {
namespace {

using testing::expectComplete;
using testing::mesh;

/// A closed curve in the plane y = 0 that starts and ends at (2, 0, 0), at an angle in radians.
Handle(Geom_BezierCurve) teardrop(double angle) {
  constexpr double kReach = 2;
  const double x = 2 + kReach * std::cos(angle / 2), z = kReach * std::sin(angle / 2);
  TColgp_Array1OfPnt poles(1, 4);
  poles(1) = poles(4) = {2, 0, 0};
  poles(2) = {x, 0, z};
  poles(3) = {x, 0, -z};
  return new Geom_BezierCurve(poles);
}

TopoDS_Face teardropFace(double angle) {
  BRepBuilderAPI_MakeWire wire(BRepBuilderAPI_MakeEdge(teardrop(angle)).Edge());
  return BRepBuilderAPI_MakeFace(wire.Wire(), true).Face();
}

double areaOf(const TopoDS_Shape& shape) {
  GProp_GProps properties;
  BRepGProp::SurfaceProperties(shape, properties);
  return properties.Mass();
}

BoundaryCorner corner(std::size_t id, const Point3& normal) {
  return {VertexId(id), {{}, normal, 0, 0}};
}

TEST(SharpSeams, GetAVertexForEachSide) {
  FrontInput input;
  input.loops = {{corner(0, {0, 0, 1}), corner(1, {0, 0, 1}), corner(0, {0, 1, 0})}};
  input.vertexCount = 2;
  std::vector<std::uint32_t> points{7, 8};
  partSharpSeams(input, points);
  EXPECT_EQ(input.vertexCount, 3u);
  EXPECT_EQ(points, (std::vector<std::uint32_t>{7, 8, 7}));
  EXPECT_EQ(input.loops[0][0].vertex, VertexId(0));
  EXPECT_EQ(input.loops[0][2].vertex, VertexId(2));
}

TEST(SharpSeams, AreNoneWhereNormalsAgreeOrAreNotKnown) {
  FrontInput input;
  input.loops = {
      {corner(0, {0, 0, 1}), corner(1, {0, 0, 1}), corner(0, unit({0.2, 0, 1})), corner(1, {})}};
  input.vertexCount = 2;
  std::vector<std::uint32_t> points{7, 8};
  partSharpSeams(input, points);
  EXPECT_EQ(input.vertexCount, 2u);
  EXPECT_EQ(points.size(), 2u);
}

TEST(SharpSeams, OfExtrusionsAreFilledAtAnyAngle) {
  for (const double angle : {0.4, 1.0, 1.6, 2.4}) {
    const TopoDS_Shape prism =
        BRepPrimAPI_MakePrism(teardropFace(angle), gp_Vec(0.3, 2, 0)).Shape();
    expectComplete(mesh(prism, 0.1), areaOf(prism), 0.01);
  }
}

TEST(SharpSeams, OfClosedRingsAreFilled) {
  const TopoDS_Shape ring =
      BRepPrimAPI_MakeRevol(teardropFace(1), gp_Ax1({0, 0, 0}, {0, 0, 1})).Shape();
  expectComplete(mesh(ring, 0.25), areaOf(ring), 0.02);
}

/// Beyond its ends, a periodic spline is on the other side.
TEST(SharpSeams, OfPeriodicSplinesAreFilled) {
  const Handle(Geom_Surface) prism = new Geom_RectangularTrimmedSurface(
      new Geom_SurfaceOfLinearExtrusion(teardrop(0.8), {0, 1, 0}), 0.0, 1.0, 0.0, 2.0);
  const Handle(Geom_BSplineSurface) spline = GeomConvert::SurfaceToBSplineSurface(prism);
  spline->SetUPeriodic();
  const TopoDS_Face face = BRepBuilderAPI_MakeFace(spline, 1e-7).Face();
  expectComplete(mesh(face, 0.1), areaOf(face), 0.01);
}

TEST(Seams, GetAVertexForEachPlaceInTheParameters) {
  FrontInput input;
  input.loops = {{corner(0, {0, 0, 1}), corner(1, {0, 0, 1}), corner(0, {0, 0, 1})}};
  input.loops[0][2].point.u = 1;
  input.vertexCount = 2;
  std::vector<std::uint32_t> points{7, 8};
  partSeams(input, points);
  EXPECT_EQ(points, (std::vector<std::uint32_t>{7, 8, 7}));
  EXPECT_EQ(input.loops[0][2].vertex, VertexId(2));
}

/// A spline with a sharp corner in it that is not taken for an edge: elements across that lean
/// against the surface.
TEST(Seams, AreNoObstacleToElementsThatLean) {
  TColgp_Array1OfPnt poles(1, 3);
  TColStd_Array1OfReal knots(1, 3);
  TColStd_Array1OfInteger uses(1, 3);
  for (int i = 1; i <= 3; ++i) {
    poles(i) = {i == 2 ? 0.6 : 2, 0, 0.6 * i};
    knots(i) = i;
    uses(i) = i == 2 ? 1 : 2;
  }
  const Handle(Geom_Curve) zigzag = new Geom_BSplineCurve(poles, knots, uses, 1);
  const TopoDS_Shape turned =
      BRepPrimAPI_MakeRevol(BRepBuilderAPI_MakeEdge(zigzag).Edge(), gp_Ax1({0, 0, 0}, {0, 0, 1}))
          .Shape();
  const Model model = testing::modelOf(turned);
  const CadSizes sizes = testing::uniform(0.4);
  const AF2Algorithm algorithm(testing::triangleSet());
  const auto sampled = sampleEdges(model.shape(), sizes, 1, {});
  const DividedEdges divided = divideEdges(model.shape(), sampled, sizes, 1, {}, {}, {});
  for (const bool ignoresNormals : {false, true}) {
    const FillRequest request{{}, {.ignoresNormals = ignoresNormals}, divided, algorithm, {}, false,
                              {}};
    FaceMesh face;
    const auto mesh = [&] { meshFace({model.shape(), sizes, {}, {}, request}, 1, 0, 500, face); };
    if (ignoresNormals)
      EXPECT_NO_THROW(mesh());
    else
      EXPECT_THROW(mesh(), GeometryError);
  }
}

}  // namespace
}  // namespace af2::geometry
