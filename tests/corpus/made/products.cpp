// What foundries and other shops make: castings, bottles, lattices, impellers, fittings.
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepBuilderAPI_Transform.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRepFilletAPI_MakeFillet.hxx>
#include <BRepGProp.hxx>
#include <BRepOffsetAPI_MakeThickSolid.hxx>
#include <BRepOffsetAPI_ThruSections.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeRevol.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <GC_MakeArcOfCircle.hxx>
#include <GProp_GProps.hxx>
#include <Geom_TrimmedCurve.hxx>
#include <TopTools_ListOfShape.hxx>
#include <TopoDS.hxx>
#include <cmath>
#include <numbers>

#include "tests/corpus/made/families.h"
#include "tests/corpus/made/shapes.h"

namespace af2::made {
namespace {

constexpr double kTurn = 2 * std::numbers::pi;

TopoDS_Shape turned(const TopoDS_Shape& shape, double turn) {
  gp_Trsf rotation;
  rotation.SetRotation(gp::OZ(), kTurn * turn);
  return BRepBuilderAPI_Transform(shape, rotation).Shape();
}

/// All edges with the largest radius of a few that OpenCASCADE can make; else none.
TopoDS_Shape roundedAll(Draw& draw, const TopoDS_Shape& shape, double most) {
  for (double radius = most * draw.between(0.3, 1); radius > 0.1 * most; radius /= 2) {
    try {
      BRepFilletAPI_MakeFillet fillet(shape);
      for (const TopoDS_Shape& edge : edgesOf(shape)) fillet.Add(radius, TopoDS::Edge(edge));
      fillet.Build();
      if (fillet.IsDone() && BRepCheck_Analyzer(fillet.Shape()).IsValid()) return fillet.Shape();
    } catch (const Standard_Failure&) {
      continue;
    }
  }
  return shape;
}

/// A box open at the bottom with bosses and ribs inside, some of its edges rounded.
TopoDS_Shape housing(Draw& draw) {
  const double x = draw.between(4, 9), y = draw.between(3, 7), z = draw.between(1.5, 4);
  const double wall = draw.between(0.1, 0.4);
  const TopoDS_Shape outside =
      roundedAll(draw, BRepPrimAPI_MakeBox(x, y, z).Shape(), draw.chance(60) ? 0.8 : 0.01);
  const TopoDS_Shape inside =
      BRepPrimAPI_MakeBox(gp_Pnt(wall, wall, -1), x - 2 * wall, y - 2 * wall, z + 1 - wall).Shape();
  TopoDS_Shape shape = cut(outside, inside);
  for (int i = draw.count(1, 4); i > 0; --i) {
    const gp_Ax2 axes(gp_Pnt(draw.between(0.8, x - 0.8), draw.between(0.8, y - 0.8), 0.1),
                      gp::DZ());
    const double radius = draw.between(0.25, 0.6);
    shape = fused(shape, BRepPrimAPI_MakeCylinder(axes, radius, z - 0.1 - wall / 2).Shape());
    shape = cut(shape, BRepPrimAPI_MakeCylinder(axes, radius * draw.between(0.3, 0.9),
                                                z * draw.between(0.3, 1.2))
                           .Shape());
  }
  for (int i = draw.count(0, 4); i > 0; --i) {
    const double at = draw.between(0.5, x - 0.5), thick = draw.between(0.03, 0.3);
    shape = fused(shape, BRepPrimAPI_MakeBox(gp_Pnt(at, wall / 2, draw.between(0.2, z / 2)), thick,
                                             y - wall, z / 2 - wall / 2)
                             .Shape());
  }
  return draw.chance(40) ? roundedAll(draw, shape, 0.1) : shape;
}

/// A square becomes a circle, or a polygon with another number of corners; with a wall or without.
TopoDS_Shape transition(Draw& draw) {
  const auto section = [&](double z) {
    const double radius = draw.between(0.6, 2);
    if (draw.chance(40)) return circle(gp_Ax2(gp_Pnt(0, 0, z), gp::DZ()), radius);
    std::vector<gp_Pnt> corners;
    const int count = draw.count(3, 6);
    for (int i = 0; i < count; ++i) corners.push_back(around(radius, (i + 0.5) / count, z));
    return polygon(corners);
  };
  BRepOffsetAPI_ThruSections sections(true, draw.chance(70), 1e-6);
  sections.AddWire(section(0));
  sections.AddWire(section(draw.between(1, 4)));
  if (draw.chance(30)) sections.AddWire(section(draw.between(5, 7)));
  TopoDS_Shape shape = sections.Shape();
  if (draw.chance(50)) return shape;
  BRepOffsetAPI_MakeThickSolid thick;
  thick.MakeThickSolidByJoin(shape, {}, draw.between(0.03, 0.2), 1e-4);
  return thick.IsDone() ? thick.Shape() : shape;
}

/// A body with a neck, rounded and hollow.
TopoDS_Shape bottle(Draw& draw) {
  const double width = draw.between(2, 4), depth = draw.between(0.8, 1.8),
               height = draw.between(3, 7);
  const gp_Pnt a(-width / 2, -depth / 2, 0), b(width / 2, -depth / 2, 0);
  const gp_Pnt c(width / 2, depth / 2, 0), d(-width / 2, depth / 2, 0);
  const double bulge = draw.between(0.1, 0.5);
  BRepBuilderAPI_MakeWire wire;
  wire.Add(
      BRepBuilderAPI_MakeEdge(GC_MakeArcOfCircle(a, gp_Pnt(0, -depth / 2 - bulge, 0), b).Value())
          .Edge());
  wire.Add(BRepBuilderAPI_MakeEdge(b, c).Edge());
  wire.Add(
      BRepBuilderAPI_MakeEdge(GC_MakeArcOfCircle(c, gp_Pnt(0, depth / 2 + bulge, 0), d).Value())
          .Edge());
  wire.Add(BRepBuilderAPI_MakeEdge(d, a).Edge());
  TopoDS_Shape shape = roundedAll(draw, extruded(flatFace(wire.Wire()), gp_Vec(0, 0, height)), 0.3);
  const double neck = draw.between(0.2, 0.45) * depth, high = draw.between(0.3, 1);
  shape = fused(
      shape, BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(0, 0, height), gp::DZ()), neck, high).Shape());
  for (const TopoDS_Shape& face : facesOf(shape)) {
    GProp_GProps properties;
    BRepGProp::SurfaceProperties(face, properties);
    if (properties.CentreOfMass().Z() < height + 0.999 * high) continue;  // no top of the neck
    TopTools_ListOfShape open;
    open.Append(face);
    BRepOffsetAPI_MakeThickSolid thick;
    thick.MakeThickSolidByJoin(shape, open, -draw.between(0.02, 0.08), 1e-3);
    if (thick.IsDone()) return thick.Shape();
  }
  return shape;
}

/// Struts between the corners of cells, balls where they meet.
TopoDS_Shape lattice(Draw& draw) {
  const double strut = draw.between(0.1, 0.25), ball = strut * draw.between(1.05, 1.8);
  const int x = draw.count(1, 2), y = draw.count(1, 2);
  const bool diagonal = draw.chance(40);
  std::vector<TopoDS_Shape> parts;
  const auto add = [&](const gp_Pnt& from, const gp_Pnt& to) {
    parts.push_back(
        BRepPrimAPI_MakeCylinder(gp_Ax2(from, gp_Dir(gp_Vec(from, to))), strut, from.Distance(to))
            .Shape());
  };
  for (int i = 0; i <= x; ++i)
    for (int j = 0; j <= y; ++j)
      for (int k = 0; k <= 1; ++k) {
        const gp_Pnt at(i, j, k);
        parts.push_back(BRepPrimAPI_MakeSphere(at, ball).Shape());
        if (i < x) add(at, gp_Pnt(i + 1, j, k));
        if (j < y) add(at, gp_Pnt(i, j + 1, k));
        if (k < 1) add(at, gp_Pnt(i, j, k + 1));
        if (diagonal && i < x && j < y && k < 1) add(at, gp_Pnt(i + 1, j + 1, k + 1));
      }
  TopoDS_Shape shape = parts[0];
  for (std::size_t i = 1; i < parts.size(); ++i) shape = fused(shape, parts[i]);
  return shape;
}

/// A hub of revolution with thin curved blades.
TopoDS_Shape impeller(Draw& draw) {
  const std::vector<gp_Pnt> points = {gp_Pnt(0.6, 0, 3), gp_Pnt(draw.between(0.7, 1), 0, 2),
                                      gp_Pnt(draw.between(1.3, 2), 0, 1), gp_Pnt(4, 0, 0.3)};
  BRepBuilderAPI_MakeWire profile(splineWire(points));
  const gp_Pnt a(4, 0, 0), b(0, 0, 0), c(0, 0, 3);
  profile.Add(BRepBuilderAPI_MakeEdge(points.back(), a).Edge());
  profile.Add(BRepBuilderAPI_MakeEdge(a, b).Edge());
  profile.Add(BRepBuilderAPI_MakeEdge(b, c).Edge());
  profile.Add(BRepBuilderAPI_MakeEdge(c, points.front()).Edge());
  TopoDS_Shape shape =
      BRepPrimAPI_MakeRevol(flatFace(profile.Wire()), gp_Ax1(gp_Pnt(), gp::DZ())).Shape();
  const double thick = draw.between(0.004, 0.02), sweep = draw.between(-0.25, 0.25);
  BRepOffsetAPI_ThruSections sections(true, draw.chance(40), 1e-6);
  for (int i = 0; i <= 4; ++i) {
    const double radius = 0.4 + 0.8 * i, turn = sweep * i / 4;
    const double low = 0.15, high = 3.2 - 0.5 * i;
    sections.AddWire(polygon({around(radius, turn - thick, low), around(radius, turn + thick, low),
                              around(radius, turn + 0.05 + thick, high),
                              around(radius, turn + 0.05 - thick, high)}));
  }
  const TopoDS_Shape blade = sections.Shape();
  const int blades = draw.count(3, 8);
  for (int i = 0; i < blades; ++i)
    shape = fused(shape, turned(blade, static_cast<double>(i) / blades));
  return shape;
}

/// A ball with dimples.
TopoDS_Shape dimpled(Draw& draw) {
  const int count = draw.count(8, 50);
  const double radius = draw.between(0.15, 0.5), deep = draw.between(0.02, 0.3);
  std::vector<TopoDS_Shape> balls;
  for (int i = 0; i < count; ++i) {
    const double z = 1 - (2 * i + 1.0) / count;  // points along a spiral
    const double distance = 3 + radius * (1 - deep);
    balls.push_back(BRepPrimAPI_MakeSphere(
                        around(distance * std::sqrt(1 - z * z), 0.618034 * i, distance * z), radius)
                        .Shape());
  }
  return cut(BRepPrimAPI_MakeSphere(3).Shape(), compound(balls));
}

/// A rod with grooves along it all around.
TopoDS_Shape splined(Draw& draw) {
  const int count = draw.count(8, 60);
  const double deep = draw.between(0.02, 0.25), wide = draw.between(0.1, 0.45) / count;
  std::vector<TopoDS_Shape> grooves;
  for (int i = 0; i < count; ++i) {
    const double turn = static_cast<double>(i) / count;
    const TopoDS_Wire wire = polygon(
        {around(2 - deep, turn, -1), around(2.2, turn + wide, -1), around(2.2, turn - wide, -1)});
    grooves.push_back(extruded(flatFace(wire), gp_Vec(0, 0, draw.chance(80) ? 4 : 2)));
  }
  TopoDS_Shape rod = BRepPrimAPI_MakeCylinder(2, draw.between(1.5, 5)).Shape();
  if (draw.chance(50)) rod = roundedAll(draw, rod, 0.3);
  return cut(rod, compound(grooves));
}

/// Pipes with elbows and branches.
TopoDS_Shape fittings(Draw& draw) {
  const double radius = draw.between(0.4, 0.9), bend = radius + draw.between(0.05, 1.5);
  const double angle = draw.between(0.5, 3);
  // The elbow begins at the end of the straight pipe.
  const gp_Ax2 up(gp_Pnt(bend, 0, 0), gp_Dir(0, -1, 0), gp_Dir(-1, 0, 0));
  TopoDS_Shape shape = BRepPrimAPI_MakeTorus(up, bend, radius, angle).Shape();
  shape =
      fused(shape, BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(0, 0, -3), gp::DZ()), radius, 3).Shape());
  const gp_Pnt origin(0, 0, draw.between(-2, -1));
  const double branch = radius * (draw.chance(30) ? 1 : draw.between(0.4, 0.99));
  shape = fused(shape, BRepPrimAPI_MakeCylinder(
                           gp_Ax2(origin, gp_Dir(draw.between(-1, 1), 1, draw.between(-0.5, 0.5))),
                           branch, 2.5)
                           .Shape());
  return draw.chance(50) ? roundedAll(draw, shape, 0.2) : shape;
}

}  // namespace

std::vector<Family> productFamilies() {
  return {{"housing", housing}, {"transition", transition}, {"bottle", bottle},
          {"lattice", lattice}, {"impeller", impeller},     {"dimpled", dimpled},
          {"splined", splined}, {"fittings", fittings}};
}

}  // namespace af2::made
