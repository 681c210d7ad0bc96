// Surfaces swept from conics.
#include <gtest/gtest.h>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <Geom_Hyperbola.hxx>
#include <gp_Hypr.hxx>

#include "tests/geometry/occ/meshing.h"
#include "tests/support/model_mesh.h"

namespace af2::geometry {
namespace {

/// Its far ends, which no face reaches, have no coordinates.
TEST(Conics, AnExtrudedHyperbolaIsMeshedAsAnyOtherCurve) {
  const gp_Hypr hyperbola(gp_Ax2({0, 0, 0}, {0, 0, 1}), 3, 2);
  const Handle(Geom_Hyperbola) curve = new Geom_Hyperbola(hyperbola);
  BRepBuilderAPI_MakeWire wire(BRepBuilderAPI_MakeEdge(hyperbola, -1.2, 1.5));
  wire.Add(BRepBuilderAPI_MakeEdge(curve->Value(1.5), curve->Value(-1.2)));
  const TopoDS_Face base = BRepBuilderAPI_MakeFace(wire.Wire());
  for (const double size : {0.2, 1.0, 5.0}) {
    const ModelMesh result =
        testing::mesh(BRepPrimAPI_MakePrism(base, gp_Vec(1, 0.5, 4)).Shape(), size);
    testing::expectComplete(result);
    EXPECT_EQ(testing::eulerNumber(result), 2);
  }
}

}  // namespace
}  // namespace af2::geometry
