// Needles: cones and revolved faces that end in a pole and are narrower than the elements.
#include <gtest/gtest.h>
#include <BRepAlgoAPI_Fuse.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeRevol.hxx>
#include <GeomAPI_PointsToBSpline.hxx>
#include <Geom_BSplineCurve.hxx>
#include <TColgp_Array1OfPnt.hxx>

#include "tests/geometry/occ/meshing.h"
#include "tests/support/model_mesh.h"

namespace af2::geometry {
namespace {

TopoDS_Shape onBlock(const TopoDS_Shape& needle) {
  const TopoDS_Shape block = BRepPrimAPI_MakeBox(gp_Pnt(-5, -5, -3), gp_Pnt(5, 5, 0)).Shape();
  return BRepAlgoAPI_Fuse(block, needle).Shape();
}

/// A spline from the base to the pole, around the axis.
TopoDS_Shape revolvedNeedle(double radius) {
  TColgp_Array1OfPnt points(1, 4);
  points(1) = gp_Pnt(radius, 0, 0);
  points(2) = gp_Pnt(1.1 * radius, 0, 3);
  points(3) = gp_Pnt(0.7 * radius, 0, 7);
  points(4) = gp_Pnt(0, 0, 10);
  BRepBuilderAPI_MakeWire wire(BRepBuilderAPI_MakeEdge(gp_Pnt(0, 0, 0), points(1)),
                               BRepBuilderAPI_MakeEdge(GeomAPI_PointsToBSpline(points).Curve()),
                               BRepBuilderAPI_MakeEdge(points(4), gp_Pnt(0, 0, 0)));
  return BRepPrimAPI_MakeRevol(BRepBuilderAPI_MakeFace(wire.Wire()).Face(),
                               gp_Ax1({0, 0, 0}, {0, 0, 1}))
      .Shape();
}

void expectSound(const TopoDS_Shape& shape, const MeshingOptions& options) {
  const ModelMesh result = testing::mesh(testing::modelOf(shape), options);
  testing::expectComplete(result);
  EXPECT_EQ(testing::eulerNumber(result), 2);
}

TEST(Needles, AreMeshedWhateverTheSmallestSize) {
  MeshingOptions options = testing::ofSize(1.5);
  options.sizes.elementsPerTurn = 12;
  for (const double least : {0.5, 1.5}) {
    options.sizes.minSize = least;
    expectSound(onBlock(BRepPrimAPI_MakeCone(0.3, 0, 10).Shape()), options);
    expectSound(onBlock(revolvedNeedle(0.1)), options);
  }
}

TEST(Needles, AreMeshedIfTheyAreShorterThanTheSize) {
  expectSound(onBlock(BRepPrimAPI_MakeCone(0.05, 0, 10).Shape()), testing::ofSize(20));
  MeshingOptions options = testing::ofSize(1.5);
  options.sizes.minSize = 0.5;
  options.sizes.elementsPerTurn = 12;
  expectSound(onBlock(BRepPrimAPI_MakeCone(0.1, 0, 1).Shape()), options);
}

}  // namespace
}  // namespace af2::geometry
