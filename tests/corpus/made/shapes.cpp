#include "tests/corpus/made/shapes.h"

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepAlgoAPI_Fuse.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <BRep_Builder.hxx>
#include <GeomAPI_Interpolate.hxx>
#include <GeomAPI_PointsToBSplineSurface.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Precision.hxx>
#include <TColgp_Array2OfPnt.hxx>
#include <TColgp_HArray1OfPnt.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <cmath>
#include <gp_Circ.hxx>
#include <numbers>

namespace af2::made {
namespace {

std::vector<TopoDS_Shape> partsOf(const TopoDS_Shape& shape, TopAbs_ShapeEnum kind) {
  TopTools_IndexedMapOfShape parts;
  TopExp::MapShapes(shape, kind, parts);
  return {parts.cbegin(), parts.cend()};
}

}  // namespace

TopoDS_Shape primitive(Draw& draw, double size) {
  const gp_Ax2 axes = draw.axes(0.4 * size);
  const double radius = draw.between(0.2, 0.6) * size;
  const double height = draw.between(0.5, 2.0) * size;
  switch (draw.count(0, 4)) {
    case 0:
      return BRepPrimAPI_MakeBox(axes, 2 * radius, draw.between(0.4, 1.5) * size, height).Shape();
    case 1:
      return BRepPrimAPI_MakeCylinder(axes, radius, height).Shape();
    case 2:
      return BRepPrimAPI_MakeCone(axes, radius, draw.chance(40) ? 0 : draw.between(0.1, 0.5) * size,
                                  height)
          .Shape();
    case 3:
      return BRepPrimAPI_MakeSphere(axes, 1.2 * radius).Shape();
    default:
      return BRepPrimAPI_MakeTorus(axes, 1.2 * radius, draw.between(0.2, 0.9) * radius).Shape();
  }
}

TopoDS_Shape fused(const TopoDS_Shape& first, const TopoDS_Shape& second) {
  return BRepAlgoAPI_Fuse(first, second).Shape();
}

TopoDS_Shape cut(const TopoDS_Shape& first, const TopoDS_Shape& second) {
  return BRepAlgoAPI_Cut(first, second).Shape();
}

TopoDS_Shape compound(const std::vector<TopoDS_Shape>& parts) {
  TopoDS_Compound whole;
  BRep_Builder builder;
  builder.MakeCompound(whole);
  for (const TopoDS_Shape& part : parts) builder.Add(whole, part);
  return whole;
}

std::vector<TopoDS_Shape> edgesOf(const TopoDS_Shape& shape) { return partsOf(shape, TopAbs_EDGE); }
std::vector<TopoDS_Shape> facesOf(const TopoDS_Shape& shape) { return partsOf(shape, TopAbs_FACE); }

gp_Pnt around(double radius, double turn, double z) {
  const double angle = 2 * std::numbers::pi * turn;
  return {radius * std::cos(angle), radius * std::sin(angle), z};
}

TopoDS_Wire polygon(const std::vector<gp_Pnt>& corners) {
  BRepBuilderAPI_MakePolygon made;
  for (const gp_Pnt& corner : corners) made.Add(corner);
  made.Close();
  return made.Wire();
}

TopoDS_Wire circle(const gp_Ax2& axes, double radius) {
  return BRepBuilderAPI_MakeWire(BRepBuilderAPI_MakeEdge(gp_Circ(axes, radius)).Edge()).Wire();
}

TopoDS_Wire splineWire(const std::vector<gp_Pnt>& points, Ends ends) {
  const Handle(TColgp_HArray1OfPnt) array =
      new TColgp_HArray1OfPnt(1, static_cast<int>(points.size()));
  for (std::size_t i = 0; i < points.size(); ++i)
    array->SetValue(static_cast<int>(i) + 1, points[i]);
  GeomAPI_Interpolate spline(array, ends == Ends::Joined, Precision::Confusion());
  spline.Perform();
  return BRepBuilderAPI_MakeWire(BRepBuilderAPI_MakeEdge(spline.Curve()).Edge()).Wire();
}

TopoDS_Face flatFace(const TopoDS_Wire& outer, const std::vector<TopoDS_Wire>& holes) {
  BRepBuilderAPI_MakeFace made(outer, true);
  for (const TopoDS_Wire& hole : holes) made.Add(TopoDS::Wire(hole.Reversed()));
  return made.Face();
}

TopoDS_Shape extruded(const TopoDS_Shape& base, const gp_Vec& along) {
  return BRepPrimAPI_MakePrism(base, along).Shape();
}

TopoDS_Face surfaceThrough(int rows, int columns,
                           const std::function<gp_Pnt(double, double)>& point) {
  TColgp_Array2OfPnt grid(1, rows, 1, columns);
  for (int i = 0; i < rows; ++i) {
    for (int j = 0; j < columns; ++j) {
      grid.SetValue(i + 1, j + 1, point(i / (rows - 1.0), j / (columns - 1.0)));
    }
  }
  GeomAPI_PointsToBSplineSurface fit;
  fit.Interpolate(grid);
  return BRepBuilderAPI_MakeFace(fit.Surface(), Precision::Confusion()).Face();
}

}  // namespace af2::made
