// Models made in memory.
#pragma once

#include <BRepAdaptor_Surface.hxx>
#include <BRepAlgoAPI_Cut.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Wire.hxx>
#include <gp_Ax3.hxx>
#include <gp_Circ.hxx>
#include <gp_Pln.hxx>

#include <vector>

#include "geometry/occ/model/model.h"
#include "geometry/occ/model/model_shape.h"

namespace af2::testing {

/// The first face of a shape that lies on a sphere; null if there is none.
inline TopoDS_Face sphereOf(const TopoDS_Shape& shape) {
  for (TopExp_Explorer it(shape, TopAbs_FACE); it.More(); it.Next())
    if (BRepAdaptor_Surface(TopoDS::Face(it.Current())).GetType() == GeomAbs_Sphere)
      return TopoDS::Face(it.Current());
  return {};
}

inline geometry::Model modelOf(const TopoDS_Shape& shape) {
  geometry::ReadShape read;
  read.shape = shape;
  return geometry::Model(geometry::makeModelShape(std::move(read)));
}

inline geometry::Model box(double x, double y, double z) {
  return modelOf(BRepPrimAPI_MakeBox(x, y, z).Shape());
}
inline geometry::Model cylinder(double radius, double height) {
  return modelOf(BRepPrimAPI_MakeCylinder(radius, height).Shape());
}
inline geometry::Model cone(double low, double high, double height) {
  return modelOf(BRepPrimAPI_MakeCone(low, high, height).Shape());
}
inline geometry::Model sphere(double radius) {
  return modelOf(BRepPrimAPI_MakeSphere(radius).Shape());
}
inline geometry::Model torus(double major, double minor) {
  return modelOf(BRepPrimAPI_MakeTorus(major, minor).Shape());
}

/// A block with a slanted hole.
inline TopoDS_Shape drilledBlock() {
  const gp_Ax2 slanted(gp_Pnt(2, 1.5, -1), gp_Dir(0.2, 0.1, 1));
  return BRepAlgoAPI_Cut(BRepPrimAPI_MakeBox(4, 3, 2).Shape(),
                         BRepPrimAPI_MakeCylinder(slanted, 0.7, 6).Shape());
}

inline TopoDS_Edge circle(double radius) {
  return BRepBuilderAPI_MakeEdge(gp_Circ(gp_Ax2({0, 0, 0}, {0, 0, 1}), radius));
}

inline TopoDS_Wire rectangle(double x1, double y1, double x2, double y2, double z = 0) {
  BRepBuilderAPI_MakePolygon polygon({x1, y1, z}, {x2, y1, z}, {x2, y2, z}, {x1, y2, z}, true);
  return polygon.Wire();
}

inline TopoDS_Face plane(const std::vector<TopoDS_Wire>& wires) {
  BRepBuilderAPI_MakeFace maker(gp_Pln(gp_Ax3({0, 0, 0}, {0, 0, 1})), wires[0]);
  for (std::size_t i = 1; i < wires.size(); ++i) maker.Add(wires[i]);
  return maker.Face();
}

}  // namespace af2::testing
