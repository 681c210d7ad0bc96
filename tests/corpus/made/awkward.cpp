// What models of users have and others do not: details below the size, needles, slits, vertices
// with large tolerances, edges beside their plane.
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeRevol.hxx>
#include <BRep_Builder.hxx>
#include <Geom_Hyperbola.hxx>
#include <Geom_Plane.hxx>
#include <TopExp.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Vertex.hxx>
#include <cmath>
#include <gp_Pln.hxx>

#include "tests/corpus/made/families.h"
#include "tests/corpus/made/shapes.h"

namespace af2::made {
namespace {

gp_Ax2 upAt(double x, double y, double z) { return {gp_Pnt(x, y, z), gp::DZ()}; }

/// A plate with holes and pins that are far smaller than an element.
TopoDS_Shape pinholes(Draw& draw) {
  TopoDS_Shape plate = BRepPrimAPI_MakeBox(20, 14, 2).Shape();
  for (int i = 0; i < 3; ++i) {
    const double x = 4 + 6 * i, y = draw.between(3, 11), radius = draw.between(0.01, 0.06);
    plate = i == 1 ? fused(plate, BRepPrimAPI_MakeCylinder(upAt(x, y, 1), radius, 3).Shape())
                   : cut(plate, BRepPrimAPI_MakeCylinder(upAt(x, y, -1), radius, 4).Shape());
  }
  return plate;
}

/// A cone, or a curve turned around the axis that it ends on, far longer than wide.
TopoDS_Shape needle(Draw& draw) {
  const double radius = draw.between(0.03, 0.3), height = draw.between(4, 9);
  if (draw.chance(50)) return BRepPrimAPI_MakeCone(radius, 0, height).Shape();
  const TopoDS_Wire side =
      splineWire({gp_Pnt(radius, 0, 0), gp_Pnt(0.8 * radius, 0, 0.4 * height),
                  gp_Pnt(0.3 * radius, 0, 0.8 * height), gp_Pnt(0, 0, height)});
  const TopoDS_Wire rest = splineWire({gp_Pnt(0, 0, height), gp_Pnt(0, 0, height / 2), gp_Pnt()});
  const TopoDS_Wire base = splineWire({gp_Pnt(), gp_Pnt(radius / 2, 0, 0), gp_Pnt(radius, 0, 0)});
  BRepBuilderAPI_MakeWire wire;
  for (const TopoDS_Wire& part : {side, rest, base}) wire.Add(part);
  const TopoDS_Face face = BRepBuilderAPI_MakeFace(wire.Wire(), true);
  return BRepPrimAPI_MakeRevol(face, gp_Ax1(gp_Pnt(), gp::DZ())).Shape();
}

/// A prism over a branch of a hyperbola and its chord.
TopoDS_Shape hyperbolicPrism(Draw& draw) {
  const Handle(Geom_Hyperbola) curve =
      new Geom_Hyperbola(gp_Ax2(), draw.between(1, 3), draw.between(0.5, 3));
  const double end = draw.between(0.5, 1.5);
  const TopoDS_Edge branch = BRepBuilderAPI_MakeEdge(curve, -end, end);
  const TopoDS_Edge chord =
      BRepBuilderAPI_MakeEdge(TopExp::LastVertex(branch), TopExp::FirstVertex(branch));
  return extruded(flatFace(BRepBuilderAPI_MakeWire(branch, chord)),
                  gp_Vec(0, 0, draw.between(1, 6)));
}

/// A plate whose boundary runs back along itself, at a distance that no element shows.
TopoDS_Shape hairSlit(Draw& draw) {
  const double width = std::pow(10, draw.between(-5, -2)), deep = draw.between(2, 7);
  const double y = draw.between(2, 4);
  const TopoDS_Wire outline =
      polygon({gp_Pnt(0, 0, 0), gp_Pnt(10, 0, 0), gp_Pnt(10, 6, 0), gp_Pnt(0, 6, 0),
               gp_Pnt(0, y + width, 0), gp_Pnt(deep, y + width / 2, 0), gp_Pnt(0, y, 0)});
  return draw.chance(50) ? TopoDS_Shape(flatFace(outline))
                         : extruded(flatFace(outline), gp_Vec(0, 0, draw.between(1, 3)));
}

/// A sheet whose lines along one parameter turn back, so that it lies on itself, seen from above.
TopoDS_Shape foldedSheet(Draw& draw) {
  const double over = draw.between(0.5, 2), lift = draw.between(0.2, 1);
  return surfaceThrough(7, 5, [&](double u, double v) {
    return gp_Pnt(6 * u - over * std::sin(6.283 * u), 5 * v, lift * u * (1 - u) * 4 + lift * u);
  });
}

/// A plate with holes that are smaller than the tolerances of their vertices.
TopoDS_Shape fatVertices(Draw& draw) {
  TopoDS_Shape plate = BRepPrimAPI_MakeBox(10, 7, 1).Shape();
  const double radius = draw.between(0.002, 0.02);
  plate = cut(plate, BRepPrimAPI_MakeCylinder(upAt(draw.between(2, 8), 3, -1), radius, 3).Shape());
  const BRep_Builder builder;
  for (const TopoDS_Shape& shape : edgesOf(plate)) {
    const TopoDS_Edge edge = TopoDS::Edge(shape);
    const TopoDS_Vertex first = TopExp::FirstVertex(edge);
    if (first.IsSame(TopExp::LastVertex(edge))) builder.UpdateVertex(first, 4 * radius);
  }
  return plate;
}

/// A plane face whose edges are beside its plane, within their tolerances.
TopoDS_Shape besideThePlane(Draw& draw) {
  const int corners = draw.count(4, 8);
  const double off = std::pow(10, draw.between(-4, -2));
  std::vector<gp_Pnt> points;
  for (int i = 0; i < corners; ++i) {
    const double angle = 2 * M_PI * i / corners, radius = draw.between(3, 6);
    points.emplace_back(radius * std::cos(angle), radius * std::sin(angle),
                        draw.between(-off, off));
  }
  const TopoDS_Wire wire = polygon(points);
  const BRep_Builder builder;
  for (const TopoDS_Shape& edge : edgesOf(wire)) {
    builder.UpdateEdge(TopoDS::Edge(edge), 2 * off);
    builder.UpdateVertex(TopExp::FirstVertex(TopoDS::Edge(edge)), 2 * off);
  }
  TopoDS_Face face;
  builder.MakeFace(face, new Geom_Plane(gp_Pln()), 2 * off);
  builder.Add(face, wire);
  return face;
}

}  // namespace

std::vector<Family> awkwardFamilies() {
  return {{"pinholes", pinholes},
          {"needle", needle},
          {"hyperbolic_prism", hyperbolicPrism},
          {"hair_slit", hairSlit},
          {"folded_sheet", foldedSheet},
          {"fat_vertices", fatVertices},
          {"beside_the_plane", besideThePlane}};
}

}  // namespace af2::made
