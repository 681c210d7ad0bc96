// Plane faces whose edges do not lie in the plane, within the tolerances of the file.
#include <gtest/gtest.h>
#include <BRepBuilderAPI_MakeVertex.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRep_Builder.hxx>
#include <GeomAPI_PointsToBSpline.hxx>
#include <Geom_BSplineCurve.hxx>
#include <TColgp_Array1OfPnt.hxx>

#include <algorithm>
#include <cmath>
#include <set>

#include "tests/geometry/occ/meshing.h"
#include "tests/support/model_mesh.h"

namespace af2::geometry {
namespace {

/// A square with side 10, one edge of which rises from the plane in an arc of a given height.
TopoDS_Face squareWithARisingEdge(double height) {
  const TopoDS_Vertex corners[] = {
      BRepBuilderAPI_MakeVertex(gp_Pnt(0, 0, 0)), BRepBuilderAPI_MakeVertex(gp_Pnt(10, 0, 0)),
      BRepBuilderAPI_MakeVertex(gp_Pnt(10, 10, 0)), BRepBuilderAPI_MakeVertex(gp_Pnt(0, 10, 0))};
  TColgp_Array1OfPnt points(1, 3);
  for (int i = 0; i < 3; ++i) points(i + 1) = gp_Pnt(5 * i, 0, i == 1 ? height : 0);
  const TopoDS_Edge rising =
      BRepBuilderAPI_MakeEdge(GeomAPI_PointsToBSpline(points).Curve(), corners[0], corners[1]);
  BRep_Builder().UpdateEdge(rising, 1.5 * height);
  BRepBuilderAPI_MakeWire wire(rising);
  for (int i = 1; i < 4; ++i)
    wire.Add(BRepBuilderAPI_MakeEdge(corners[i], corners[(i + 1) % 4]).Edge());
  return BRepBuilderAPI_MakeFace(gp_Pln(), wire.Wire());
}

/// They followed the edge from which the front came to them, if it was only a little off.
TEST(InexactPlanes, HaveTheirInnerVerticesInThePlane) {
  for (const double height : {0.0005, 0.05}) {
    const ModelMesh result = testing::mesh(squareWithARisingEdge(height), 0.7);
    testing::expectComplete(result);
    std::set<std::uint32_t> onEdges;
    for (const EdgeSegment& segment : result.segments)
      onEdges.insert({segment.from.value, segment.to.value});
    double farthest = 0;
    for (std::uint32_t v = 0; v < result.vertices.size(); ++v)
      if (!onEdges.contains(v)) farthest = std::max(farthest, std::abs(result.vertices[v].z));
    EXPECT_LT(farthest, 1e-5);
  }
}

}  // namespace
}  // namespace af2::geometry
