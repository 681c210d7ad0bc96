// Models as they should not be, made in memory.
#pragma once

#include <BRepAlgoAPI_BuilderAlgo.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepBuilderAPI_MakeVertex.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Geom2d_Line.hxx>
#include <Geom_CylindricalSurface.hxx>
#include <Geom_Plane.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_ListOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Shell.hxx>
#include <TopoDS_Solid.hxx>
#include <gp_Pln.hxx>

#include <initializer_list>
#include <utility>
#include <vector>

#include "geometry/occ/base/points.h"
#include "geometry/occ/model/model.h"
#include "geometry/occ/model/model_shape.h"

namespace af2::testing {

inline TopoDS_Compound compoundOf(const std::vector<TopoDS_Shape>& shapes) {
  BRep_Builder builder;
  TopoDS_Compound all;
  builder.MakeCompound(all);
  for (const TopoDS_Shape& shape : shapes) builder.Add(all, shape);
  return all;
}

/// A plane face at z = 0 with these corners.
inline TopoDS_Face polygon(const std::vector<gp_Pnt>& corners) {
  BRepBuilderAPI_MakePolygon wire;
  for (const gp_Pnt& corner : corners) wire.Add(corner);
  wire.Close();
  return BRepBuilderAPI_MakeFace(gp_Pln(gp_Ax3({0, 0, 0}, {0, 0, 1})), wire.Wire());
}

inline std::pair<Point3, Point3> endsOf(const geometry::Model& model, int edge) {
  const TopoDS_Edge shape = model.shape().edge(edge);
  return {geometry::toPoint(BRep_Tool::Pnt(TopExp::FirstVertex(shape))),
          geometry::toPoint(BRep_Tool::Pnt(TopExp::LastVertex(shape)))};
}

/// A square at z = 0 with a hole between the corners, which run clockwise.
inline TopoDS_Face plateWithHole(double side, const std::vector<gp_Pnt>& corners) {
  BRepBuilderAPI_MakePolygon hole;
  for (const gp_Pnt& corner : corners) hole.Add(corner);
  hole.Close();
  const TopoDS_Face plate = polygon({{0, 0, 0}, {side, 0, 0}, {side, side, 0}, {0, side, 0}});
  return BRepBuilderAPI_MakeFace(plate, hole.Wire());
}

/// A plane face at z = 0 within edges between the corners, in this order; -1: none to the next.
inline TopoDS_Face faceWithin(const std::vector<gp_Pnt>& corners, const std::vector<int>& order) {
  BRep_Builder builder;
  std::vector<TopoDS_Vertex> vertices;
  for (const gp_Pnt& corner : corners) vertices.push_back(BRepBuilderAPI_MakeVertex(corner));
  TopoDS_Wire wire;
  builder.MakeWire(wire);
  for (std::size_t i = 0; i + 1 < order.size(); ++i) {
    if (order[i] < 0 || order[i + 1] < 0) continue;
    const auto at = [&](int k) { return vertices[static_cast<std::size_t>(k)]; };
    builder.Add(wire, BRepBuilderAPI_MakeEdge(at(order[i]), at(order[i + 1])).Edge());
  }
  TopoDS_Face face;
  builder.MakeFace(face, new Geom_Plane(gp_Pln(gp_Ax3({0, 0, 0}, {0, 0, 1}))), 1e-7);
  builder.Add(face, wire);
  return face;
}

/// Two unit squares that touch at (1, 1), in one loop.
inline TopoDS_Face touchingLoop() {
  return faceWithin({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {2, 1, 0}, {2, 2, 0}, {1, 2, 0}, {0, 1, 0}},
                    {0, 1, 2, 3, 4, 5, 2, 6, 0});
}

/// A loop whose edges cross between their ends.
inline TopoDS_Face crossingLoop() {
  return faceWithin({{0, 0, 0}, {1, 1, 0}, {1, 0, 0}, {0, 1, 0}}, {0, 1, 2, 3, 0});
}

/// Three sides of a square.
inline TopoDS_Face openLoop() {
  return faceWithin({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {0, 1, 2, 3});
}

/// A quarter of a tube of radius and height 1, with edges in its parameters only.
inline TopoDS_Face withoutCurves() {
  const Handle(Geom_Surface) tube = new Geom_CylindricalSurface(gp_Ax3({0, 0, 0}, {0, 0, 1}), 1);
  const double quarter = 1.5707963267948966;
  const std::vector<gp_Pnt2d> corners{{0, 0}, {quarter, 0}, {quarter, 1}, {0, 1}};
  BRepBuilderAPI_MakeWire wire;
  for (std::size_t i = 0; i < 4; ++i) {
    const gp_Vec2d way(corners[i], corners[(i + 1) % 4]);
    wire.Add(BRepBuilderAPI_MakeEdge(new Geom2d_Line(corners[i], gp_Dir2d(way)), tube, 0,
                                     way.Magnitude()));
  }
  BRep_Builder builder;
  TopoDS_Face face;
  builder.MakeFace(face, tube, 1e-7);
  builder.Add(face, wire.Wire());
  return face;
}

/// A cube of side 1 with one face turned inside out.
inline TopoDS_Solid turnedFace() {
  BRep_Builder builder;
  TopoDS_Shell shell;
  builder.MakeShell(shell);
  int count = 0;
  for (TopExp_Explorer it(BRepPrimAPI_MakeBox(1, 1, 1).Shape(), TopAbs_FACE); it.More(); it.Next())
    builder.Add(shell, count++ == 2 ? it.Current().Reversed() : it.Current());
  TopoDS_Solid solid;
  builder.MakeSolid(solid);
  builder.Add(solid, shell);
  return solid;
}

/// Two cubes of side 1 that share the face between them.
inline TopoDS_Shape sharedFace() {
  TopTools_ListOfShape boxes;
  boxes.Append(BRepPrimAPI_MakeBox(1, 1, 1).Shape());
  boxes.Append(BRepPrimAPI_MakeBox(gp_Pnt(1, 0, 0), 1, 1, 1).Shape());
  BRepAlgoAPI_BuilderAlgo fuse;
  fuse.SetArguments(boxes);
  fuse.Build();
  return fuse.Shape();
}

/// A block of height 1 over a square of side 1, one side of which has a step as small as `tiny`.
inline TopoDS_Shape tinyStep(double tiny) {
  return BRepPrimAPI_MakePrism(polygon({{0, 0, 0},
                                        {1, 0, 0},
                                        {1, 0.5, 0},
                                        {1 - tiny, 0.5, 0},
                                        {1 - tiny, 1, 0},
                                        {0, 1, 0}}),
                               gp_Vec(0, 0, 1))
      .Shape();
}

}  // namespace af2::testing
