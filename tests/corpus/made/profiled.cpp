// What is bent, cut or milled from one profile: sheet metal, heat sinks, gears.
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepOffsetAPI_MakePipeShell.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeRevol.hxx>
#include <GC_MakeArcOfCircle.hxx>
#include <Geom_TrimmedCurve.hxx>
#include <TopoDS.hxx>
#include <cmath>
#include <gp_Elips.hxx>
#include <gp_Hypr.hxx>
#include <gp_Parab.hxx>
#include <numbers>
#include <utility>

#include "tests/corpus/made/families.h"
#include "tests/corpus/made/shapes.h"

namespace af2::made {
namespace {

constexpr double kTurn = 2 * std::numbers::pi;

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

}  // namespace

std::vector<Family> profiledFamilies() {
  return {{"heat_sink", heatSink},
          {"sheet_metal", sheetMetal},
          {"involute_gear", involuteGear},
          {"twisted", twisted},
          {"conics", conics}};
}

}  // namespace af2::made
