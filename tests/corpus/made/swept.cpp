// Lofts, pipes, springs, threads, revolutions: what comes of curves.
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeVertex.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepFilletAPI_MakeFillet.hxx>
#include <BRepLib.hxx>
#include <BRepOffsetAPI_MakePipe.hxx>
#include <BRepOffsetAPI_MakePipeShell.hxx>
#include <BRepOffsetAPI_ThruSections.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeRevol.hxx>
#include <Geom2d_Line.hxx>
#include <Geom_ConicalSurface.hxx>
#include <Geom_CylindricalSurface.hxx>
#include <TopoDS.hxx>
#include <cmath>
#include <gp_Ax1.hxx>
#include <numbers>

#include "tests/corpus/made/families.h"
#include "tests/corpus/made/shapes.h"

namespace af2::made {
namespace {

constexpr double kTurn = 2 * std::numbers::pi;

/// A wire around (x, y) at a height: a circle, a polygon or a closed spline.
TopoDS_Wire section(Draw& draw, const gp_Ax2& axes, double size) {
  const gp_Vec x(axes.XDirection());
  const gp_Vec y(axes.YDirection());
  const auto at = [&](double radius, double turn) {
    return axes.Location().Translated(x * (radius * std::cos(kTurn * turn)) +
                                      y * (radius * std::sin(kTurn * turn)));
  };
  const int kind = draw.count(0, 2);
  if (kind == 0) return circle(axes, size);
  const int corners = draw.count(kind == 1 ? 3 : 4, 8);
  std::vector<gp_Pnt> points;
  for (int i = 0; i < corners; ++i)
    points.push_back(at(size * draw.between(0.7, 1.2), static_cast<double>(i) / corners));
  return kind == 1 ? polygon(points) : splineWire(points, Ends::Joined);
}

TopoDS_Shape loft(Draw& draw) {
  BRepOffsetAPI_ThruSections sections(true, draw.chance(30), 1e-6);
  const int levels = draw.count(2, 5);
  gp_Pnt origin;
  for (int i = 0; i < levels; ++i) {
    const gp_Dir normal(draw.between(-0.15, 0.15), draw.between(-0.15, 0.15), 1);
    sections.AddWire(section(draw, gp_Ax2(origin, normal, gp_Dir(1, 0, -normal.X() / normal.Z())),
                             draw.between(0.7, 1.5)));
    origin.Translate(gp_Vec(draw.between(-1, 1), draw.between(-1, 1), draw.between(1, 3)));
  }
  if (draw.chance(20)) sections.AddVertex(BRepBuilderAPI_MakeVertex(origin));
  return sections.Shape();
}

/// A loft through wires of the same kind, as blades and bottles have them.
TopoDS_Shape evenLoft(Draw& draw) {
  BRepOffsetAPI_ThruSections sections(draw.chance(80), draw.chance(20), 1e-6);
  const int levels = draw.count(2, 6);
  const int corners = draw.count(3, 9);
  const bool smooth = draw.chance(60);
  const double twist = draw.between(-0.2, 0.2);
  for (int i = 0; i < levels; ++i) {
    std::vector<gp_Pnt> points;
    const double radius = draw.between(0.8, 2);
    for (int k = 0; k < corners; ++k) {
      const double angle = kTurn * (static_cast<double>(k) / corners + i * twist);
      points.emplace_back(radius * std::cos(angle), 0.7 * radius * std::sin(angle), 1.5 * i);
    }
    sections.AddWire(smooth ? splineWire(points, Ends::Joined) : polygon(points));
  }
  return sections.Shape();
}

/// A wing through profiles of four digits, its trailing edge sharp or blunt.
TopoDS_Shape wing(Draw& draw) {
  const double thickness = draw.between(0.06, 0.24);
  const double camber = draw.between(0, 0.06);
  const double blunt = draw.chance(50) ? 0 : draw.between(0.0005, 0.01);
  const auto profile = [&](double chord, const gp_Vec& shift, double pitch) {
    std::vector<gp_Pnt> upper;
    std::vector<gp_Pnt> lower;
    for (int i = 0; i <= 16; ++i) {
      const double x = 0.5 * (1 + std::cos(std::numbers::pi * i / 16));
      const double half = 5 * thickness *
                          (0.2969 * std::sqrt(x) - 0.126 * x - 0.3516 * x * x + 0.2843 * x * x * x -
                           0.1036 * x * x * x * x);
      const double middle = 4 * camber * x * (1 - x);
      const auto at = [&](double z) {
        return gp_Pnt(chord * (x * std::cos(pitch) + z * std::sin(pitch)), 0,
                      chord * (z * std::cos(pitch) - x * std::sin(pitch)))
            .Translated(shift);
      };
      upper.push_back(at(middle + half + blunt * x));
      if (i < 16) lower.push_back(at(middle - half - blunt * x));
    }
    lower.push_back(upper.back());
    BRepBuilderAPI_MakeWire wire(splineWire(upper));
    std::vector<gp_Pnt> back(lower.rbegin(), lower.rend());
    wire.Add(splineWire(back));
    if (blunt > 0) wire.Add(BRepBuilderAPI_MakeEdge(back.back(), upper.front()).Edge());
    return wire.Wire();
  };
  BRepOffsetAPI_ThruSections sections(true, draw.chance(50), 1e-6);
  const int ribs = draw.count(2, 4);
  const double taper = draw.between(0.05, 0.95);
  for (int i = 0; i < ribs; ++i) {
    const double along = i / (ribs - 1.0);
    sections.AddWire(profile(1 - taper * along,
                             gp_Vec(draw.between(0, 0.8) * along, 4 * along, 0.3 * along),
                             draw.between(0, 0.1) * i));
  }
  return sections.Shape();
}

TopoDS_Shape bentPipe(Draw& draw) {
  std::vector<gp_Pnt> points = {gp_Pnt()};
  for (int i = draw.count(2, 5); i > 0; --i) {
    points.push_back(points.back().Translated(
        gp_Vec(draw.between(1, 3), draw.between(-2, 2), draw.between(-2, 2))));
  }
  const TopoDS_Wire spine = splineWire(points);
  const gp_Ax2 start(points[0], gp_Dir(gp_Vec(points[0], points[1])));
  const double radius = draw.between(0.15, 0.4);
  TopoDS_Shape base = flatFace(circle(start, radius));
  if (draw.chance(40))
    base = flatFace(circle(start, radius), {circle(start, radius * draw.between(0.5, 0.95))});
  return BRepOffsetAPI_MakePipe(spine, base).Shape();
}

/// Straight pipes with corners mitred or round.
TopoDS_Shape elbows(Draw& draw) {
  std::vector<gp_Pnt> points = {gp_Pnt()};
  const gp_Dir along[] = {gp::DX(), gp::DY(), gp::DZ()};
  int axis = 0;
  for (int i = draw.count(2, 5); i > 0; --i) {
    points.push_back(points.back().Translated(gp_Vec(along[axis]) * draw.between(2, 4)));
    axis = (axis + draw.count(1, 2)) % 3;
  }
  BRepBuilderAPI_MakeWire spine;
  for (std::size_t i = 1; i < points.size(); ++i)
    spine.Add(BRepBuilderAPI_MakeEdge(points[i - 1], points[i]).Edge());
  BRepOffsetAPI_MakePipeShell sweep(spine.Wire());
  sweep.SetTransitionMode(draw.chance(50) ? BRepBuilderAPI_RoundCorner
                                          : BRepBuilderAPI_RightCorner);
  const gp_Ax2 start(points[0], gp::DX());
  sweep.Add(draw.chance(70) ? circle(start, draw.between(0.2, 0.8))
                            : section(draw, start, draw.between(0.2, 0.6)));
  sweep.Build();
  if (draw.chance(80)) sweep.MakeSolid();
  return sweep.Shape();
}

TopoDS_Wire helix(double radius, double pitch, double turns, double slope) {
  Handle(Geom_Surface) surface;
  if (slope == 0) {
    surface = new Geom_CylindricalSurface(gp::XOY(), radius);
  } else {
    surface = new Geom_ConicalSurface(gp::XOY(), slope, radius);
  }
  const double step = std::hypot(kTurn, pitch);
  const Handle(Geom2d_Line) line = new Geom2d_Line(gp_Pnt2d(), gp_Dir2d(kTurn, pitch));
  const TopoDS_Edge edge = BRepBuilderAPI_MakeEdge(line, surface, 0, turns * step).Edge();
  const TopoDS_Wire wire = BRepBuilderAPI_MakeWire(edge).Wire();
  BRepLib::BuildCurves3d(wire);
  return wire;
}

TopoDS_Shape spring(Draw& draw) {
  const double radius = draw.between(1, 3);
  const double pitch = draw.between(0.5, 2);
  BRepOffsetAPI_MakePipeShell sweep(
      helix(radius, pitch, draw.between(0.5, 6), draw.chance(70) ? 0 : draw.between(-0.1, 0.3)));
  sweep.SetMode(gp_Dir(0, 0, 1));
  const gp_Ax2 start(gp_Pnt(radius, 0, 0), gp_Dir(0, kTurn * radius, pitch));
  sweep.Add(section(draw, start, draw.between(0.1, 0.4) * pitch));
  sweep.Build();
  if (draw.chance(80)) sweep.MakeSolid();
  return sweep.Shape();
}

/// A rod with a groove cut along a helix.
TopoDS_Shape thread(Draw& draw) {
  const double pitch = draw.between(0.3, 0.8);
  const double turns = draw.between(2, 6);
  BRepOffsetAPI_MakePipeShell sweep(helix(1, pitch, turns, 0));
  sweep.SetMode(gp_Dir(0, 0, 1));
  const double deep = draw.between(0.3, 0.7) * pitch;
  const double wide = draw.between(0.2, 0.45) * pitch;
  sweep.Add(polygon({gp_Pnt(1 - deep, 0, 0), gp_Pnt(1.1, 0, -wide), gp_Pnt(1.1, 0, wide)}));
  sweep.Build();
  sweep.MakeSolid();
  const double end = draw.chance(50) ? 1.0 : -0.3;
  const TopoDS_Shape rod =
      BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(0, 0, -end), gp::DZ()), 1, turns * pitch + 2 * end)
          .Shape();
  return draw.chance(75) ? cut(rod, sweep.Shape()) : fused(rod, sweep.Shape());
}

/// What is turned on a lathe; the profile starts and ends on the axis, flat, pointed or blunt.
TopoDS_Shape vase(Draw& draw) {
  std::vector<gp_Pnt> points = {gp_Pnt(0, 0, 0)};
  double height = draw.chance(50) ? 0 : draw.between(-0.5, 0.5);
  for (int i = draw.count(3, 6); i > 0; --i) {
    points.emplace_back(draw.between(0.4, 2), 0, height);
    height += draw.between(0.4, 1.5);
  }
  const bool tip = draw.chance(60);
  if (tip) points.emplace_back(0, 0, height);
  BRepBuilderAPI_MakeWire profile(splineWire(points));
  if (!tip)
    profile.Add(BRepBuilderAPI_MakeEdge(points.back(), gp_Pnt(0, 0, points.back().Z())).Edge());
  const double angle = draw.chance(60) ? kTurn : draw.between(0.3, 6);
  if (draw.chance(30))
    return BRepPrimAPI_MakeRevol(profile.Wire(), gp_Ax1(gp_Pnt(), gp::DZ()), angle).Shape();
  profile.Add(BRepBuilderAPI_MakeEdge(gp_Pnt(0, 0, points.back().Z()), points.front()).Edge());
  return BRepPrimAPI_MakeRevol(flatFace(profile.Wire()), gp_Ax1(gp_Pnt(), gp::DZ()), angle).Shape();
}

/// A polygon or spline turned about an axis it touches, crosses nowhere or keeps away from.
TopoDS_Shape ring(Draw& draw) {
  const gp_Ax2 axes(gp_Pnt(draw.chance(50) ? 2 : draw.between(1.3, 5), 0, 0), gp_Dir(0, -1, 0));
  const double angle = draw.chance(60) ? kTurn : draw.between(0.3, 6);
  return BRepPrimAPI_MakeRevol(flatFace(section(draw, axes, 1)), gp_Ax1(gp_Pnt(), gp::DZ()), angle)
      .Shape();
}

/// A hub with blades that are twisted around it.
TopoDS_Shape propeller(Draw& draw) {
  TopoDS_Shape shape =
      BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(0, 0, -0.6), gp::DZ()), 1, 1.2).Shape();
  const int blades = draw.count(2, 6);
  const double twist = draw.between(0.2, 0.8);
  const double root = draw.between(0.3, 0.55);
  const double taper = draw.between(-0.1, 0.6);
  BRepOffsetAPI_ThruSections sections(true, true, 1e-6);
  for (int i = 0; i < 4; i += 3) {
    const double pitch = 0.3 + twist * i / 3.0;
    const gp_Vec along(0, std::cos(pitch), std::sin(pitch));
    const gp_Vec up(0, -std::sin(pitch), std::cos(pitch));
    const double chord = root * (1 - taper * i / 3.0);
    const gp_Pnt origin(0.6 + i, 0, 0);
    std::vector<gp_Pnt> points;
    for (const auto& [x, z] : {std::pair(1.0, 0.0),
                               {0.4, 0.12},
                               {-0.5, 0.12},
                               {-1.0, 0.0},
                               {-0.5, -0.05},
                               {0.4, -0.05}}) {
      points.push_back(origin.Translated(along * (chord * x) + up * (chord * z)));
    }
    sections.AddWire(splineWire(points, Ends::Joined));
  }
  const TopoDS_Shape blade = sections.Shape();
  for (int i = 0; i < blades; ++i) {
    gp_Trsf turn;
    turn.SetRotation(gp_Ax1(gp_Pnt(), gp::DZ()), kTurn * i / blades);
    shape = fused(shape, blade.Moved(TopLoc_Location(turn)));
  }
  return shape;
}

/// A flat shape with arcs and splines around it, holes in it, extruded straight or askew.
TopoDS_Shape profile(Draw& draw) {
  const gp_Ax2 axes = gp::XOY();
  std::vector<TopoDS_Wire> holes;
  if (draw.chance(50)) holes.push_back(section(draw, axes, draw.between(0.05, 0.6)));
  const gp_Vec along(draw.chance(30) ? draw.between(-2, 2) : 0, 0, draw.between(0.05, 4));
  return extruded(flatFace(section(draw, axes, draw.between(1.2, 3)), holes), along);
}

}  // namespace

std::vector<Family> sweptFamilies() {
  return {{"loft", loft},           {"even_loft", evenLoft}, {"wing", wing},
          {"bent_pipe", bentPipe},  {"elbows", elbows},      {"spring", spring},
          {"thread", thread},       {"vase", vase},          {"ring", ring},
          {"propeller", propeller}, {"profile", profile}};
}

}  // namespace af2::made
