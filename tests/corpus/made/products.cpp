// What workshops and foundries make: sheet metal, castings, heat sinks, gears, bottles, impellers.
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepBuilderAPI_Transform.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRepFilletAPI_MakeFillet.hxx>
#include <BRepGProp.hxx>
#include <BRepOffsetAPI_MakePipeShell.hxx>
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
#include <gp_Elips.hxx>
#include <gp_Hypr.hxx>
#include <gp_Parab.hxx>
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

gp_Pnt around(double radius, double turn, double z = 0) {
  return {radius * std::cos(kTurn * turn), radius * std::sin(kTurn * turn), z};
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

/// Thin fins side by side on a plate.
TopoDS_Shape heatSink(Draw& draw) {
  const int fins = draw.count(5, 24);
  const double thick = draw.between(0.03, 0.6), high = draw.between(0.5, 5);
  std::vector<gp_Pnt> corners = {gp_Pnt(0, 0, -0.8), gp_Pnt(fins, 0, -0.8)};
  const double taper = draw.between(0.5, 1);
  for (int i = fins - 1; i >= 0; --i) {
    const double middle = i + 0.5;
    corners.emplace_back(middle + thick / 2, 0, 0);
    corners.emplace_back(middle + taper * thick / 2, 0, high);
    corners.emplace_back(middle - taper * thick / 2, 0, high);
    corners.emplace_back(middle - thick / 2, 0, 0);
  }
  TopoDS_Shape shape = extruded(flatFace(polygon(corners)), gp_Vec(0, draw.between(1, 8), 0));
  for (int i = draw.count(0, 3); i > 0; --i)
    shape = cut(shape, BRepPrimAPI_MakeCylinder(
                           gp_Ax2(gp_Pnt(draw.between(0, fins), draw.between(0, 3), -5), gp::DZ()),
                           draw.between(0.1, 0.8), 20)
                           .Shape());
  return shape;
}

/// A strip bent several times, with holes; made by the path of both its sides.
TopoDS_Shape sheetMetal(Draw& draw) {
  const double thick = draw.between(0.03, 0.2), inner = draw.between(0.02, 0.4);
  std::vector<std::pair<gp_Pnt, gp_Pnt>> sides;  // right, left
  std::vector<std::pair<gp_Pnt, gp_Pnt>> bends;  // middles of arcs; equal ones: a straight part
  gp_Pnt at;
  double heading = 0;
  const auto across = [&](double where) {
    return gp_Pnt(at.X() - where * std::sin(heading), 0, at.Z() + where * std::cos(heading));
  };
  const auto add = [&] { sides.emplace_back(across(0), across(thick)); };
  add();
  for (int i = draw.count(1, 4); i >= 0; --i) {
    const double along = draw.between(0.5, 3);
    at.Translate(gp_Vec(std::cos(heading), 0, std::sin(heading)) * along);
    add();
    bends.emplace_back();
    if (i == 0) break;
    const bool left = draw.chance(60);
    const double angle = draw.between(0.5, 1.6);
    const double side = left ? inner + thick : -inner;
    const gp_Pnt center = across(side);
    const auto after = [&](double turn) {
      heading += left ? turn : -turn;
      at = gp_Pnt(center.X() + side * std::sin(heading), 0, center.Z() - side * std::cos(heading));
    };
    after(angle / 2);
    const std::pair<gp_Pnt, gp_Pnt> middle(across(0), across(thick));
    after(angle / 2);
    add();
    bends.push_back(middle);
  }
  BRepBuilderAPI_MakeWire wire;
  const auto join = [&](const gp_Pnt& from, const gp_Pnt& middle, const gp_Pnt& to, bool straight) {
    wire.Add(straight
                 ? BRepBuilderAPI_MakeEdge(from, to).Edge()
                 : BRepBuilderAPI_MakeEdge(GC_MakeArcOfCircle(from, middle, to).Value()).Edge());
  };
  for (std::size_t i = 0; i < bends.size(); ++i)
    join(sides[i].first, bends[i].first, sides[i + 1].first, i % 2 == 0);
  join(sides.back().first, {}, sides.back().second, true);
  for (std::size_t i = bends.size(); i-- > 0;)
    join(sides[i + 1].second, bends[i].second, sides[i].second, i % 2 == 0);
  join(sides[0].second, {}, sides[0].first, true);
  const double width = draw.between(1, 5);
  TopoDS_Shape shape = extruded(flatFace(wire.Wire()), gp_Vec(0, width, 0));
  for (int i = draw.count(0, 4); i > 0; --i) {
    const gp_Ax2 axes(gp_Pnt(draw.between(-1, 4), draw.between(0, width), draw.between(-1, 3)),
                      draw.chance(50) ? gp::DX() : gp::DZ());
    const gp_Ax2 back = axes.Translated(gp_Vec(axes.Direction()) * -10);
    shape = cut(shape, BRepPrimAPI_MakeCylinder(back, draw.between(0.05, 0.5), 20).Shape());
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

/// Teeth with involute flanks.
TopoDS_Shape involuteGear(Draw& draw) {
  const int teeth = draw.count(9, 40);
  const double base = 5, outer = base * (1 + draw.between(1.4, 2.4) / teeth);
  const double root = base * (1 - draw.between(0.2, 0.8) / teeth);
  const double half =
      draw.between(0.28, 0.36) / teeth;  // turn from the middle of a tooth at its base
  const double end = std::sqrt(outer * outer / (base * base) - 1);
  const auto flank = [&](int tooth, double side) {
    std::vector<gp_Pnt> points;
    for (int k = 0; k <= 8; ++k) {
      const double t = end * k / 8;
      const double turn = (t - std::atan(t)) / kTurn;
      points.push_back(around(base * std::hypot(1, t),
                              static_cast<double>(tooth) / teeth + side * (half - turn)));
    }
    return points;
  };
  BRepBuilderAPI_MakeWire wire;
  for (int i = 0; i < teeth; ++i) {
    std::vector<gp_Pnt> up = flank(i, -1), down = flank(i, 1);
    const gp_Pnt top = around(outer, static_cast<double>(i) / teeth);
    const gp_Pnt next = flank((i + 1) % teeth, -1).front();
    const gp_Pnt bottom = around(root, (i + 0.5) / teeth);
    std::vector<gp_Pnt> back(down.rbegin(), down.rend());
    wire.Add(splineWire(up));
    wire.Add(
        BRepBuilderAPI_MakeEdge(GC_MakeArcOfCircle(up.back(), top, back.front()).Value()).Edge());
    wire.Add(splineWire(back));
    wire.Add(BRepBuilderAPI_MakeEdge(GC_MakeArcOfCircle(back.back(), bottom, next).Value()).Edge());
  }
  const TopoDS_Face face =
      flatFace(wire.Wire(), {circle(gp::XOY(), draw.between(0.5, 0.8 * root))});
  const double height = draw.between(0.3, 3);
  if (draw.chance(60)) return extruded(face, gp_Vec(0, 0, height));
  // A helical gear.
  const TopoDS_Wire spine =
      BRepBuilderAPI_MakeWire(BRepBuilderAPI_MakeEdge(gp_Pnt(), gp_Pnt(0, 0, height)).Edge());
  std::vector<gp_Pnt> guide;
  const double twist = draw.between(-0.15, 0.15);
  for (int i = 0; i <= 8; ++i) guide.push_back(around(1, twist * i / 8, height * i / 8));
  BRepOffsetAPI_MakePipeShell sweep(spine);
  sweep.SetMode(splineWire(guide), true);
  sweep.Add(wire.Wire());
  sweep.Build();
  sweep.MakeSolid();
  return sweep.Shape();
}

/// A profile twisted along a line.
TopoDS_Shape twisted(Draw& draw) {
  const double height = draw.between(2, 8), twist = draw.between(-1, 1);
  const TopoDS_Wire spine =
      BRepBuilderAPI_MakeWire(BRepBuilderAPI_MakeEdge(gp_Pnt(), gp_Pnt(0, 0, height)).Edge());
  std::vector<gp_Pnt> guide, corners;
  for (int i = 0; i <= 16; ++i) guide.push_back(around(1, twist * i / 16, height * i / 16));
  const int count = draw.count(3, 7);
  for (int i = 0; i < count; ++i)
    corners.push_back(around(draw.between(0.5, 1.5), static_cast<double>(i) / count));
  BRepOffsetAPI_MakePipeShell sweep(spine);
  sweep.SetMode(splineWire(guide), true);
  sweep.Add(draw.chance(60) ? polygon(corners) : splineWire(corners, Ends::Joined));
  sweep.Build();
  sweep.MakeSolid();
  return sweep.Shape();
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

/// Arcs of ellipses, parabolas and hyperbolas, extruded or turned.
TopoDS_Shape conics(Draw& draw) {
  const gp_Ax2 axes(gp_Pnt(), gp::DY(), gp::DX());
  const double end = draw.between(0.5, 1.5), shape = draw.between(0.05, 2);
  TopoDS_Edge edge;
  switch (draw.count(0, 2)) {
    case 0:
      edge = BRepBuilderAPI_MakeEdge(gp_Elips(axes, 1 + shape, 1), 0, end);
      break;
    case 1:
      edge = BRepBuilderAPI_MakeEdge(gp_Parab(axes, shape), 0, 2 * end);
      break;
    default:
      edge = BRepBuilderAPI_MakeEdge(gp_Hypr(axes, 0.5, shape), 0, end);
  }
  const BRepBuilderAPI_MakeWire curve(edge);
  const gp_Ax1 axis(gp_Pnt(), gp::DX());
  if (draw.chance(60)) {
    const double angle = draw.chance(50) ? kTurn : draw.between(0.5, 6);
    return BRepPrimAPI_MakeRevol(edge, axis, angle).Shape();
  }
  return extruded(edge, gp_Vec(draw.between(-1, 1), draw.between(0.3, 3), 0));
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
  return {{"heat_sink", heatSink}, {"sheet_metal", sheetMetal},
          {"housing", housing},    {"involute_gear", involuteGear},
          {"twisted", twisted},    {"transition", transition},
          {"bottle", bottle},      {"lattice", lattice},
          {"impeller", impeller},  {"dimpled", dimpled},
          {"splined", splined},    {"conics", conics},
          {"fittings", fittings}};
}

}  // namespace af2::made
