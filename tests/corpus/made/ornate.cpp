// Surfaces between curves, uneven and kinked splines, many holes, long and ragged boundaries.
#include <BRepAlgoAPI_Common.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_Sewing.hxx>
#include <BRepFill.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <BRep_Tool.hxx>
#include <GeomFill_BSplineCurves.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Geom_BezierSurface.hxx>
#include <Precision.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColStd_Array2OfReal.hxx>
#include <TColgp_Array2OfPnt.hxx>
#include <TopoDS.hxx>
#include <cmath>
#include <gp_Ax3.hxx>
#include <numbers>

#include "tests/corpus/made/families.h"
#include "tests/corpus/made/shapes.h"

namespace af2::made {
namespace {

constexpr double kTurn = 2 * std::numbers::pi;

TopoDS_Edge splineEdge(const std::vector<gp_Pnt>& points) {
  return TopoDS::Edge(edgesOf(splineWire(points))[0]);
}

TopoDS_Face wholeFace(const Handle(Geom_Surface) & surface) {
  return BRepBuilderAPI_MakeFace(surface, Precision::Confusion()).Face();
}

std::vector<gp_Pnt> wander(Draw& draw, double y, double z, int count) {
  std::vector<gp_Pnt> points;
  for (int i = 0; i < count; ++i)
    points.emplace_back(6.0 * i / (count - 1), y + draw.between(-0.7, 0.7),
                        z + draw.between(-0.7, 0.7));
  return points;
}

/// Straight lines between two curves; twisted, or pinched where the curves come near.
TopoDS_Shape ruled(Draw& draw) {
  const double apart = draw.between(0.8, 4);
  const TopoDS_Face face = BRepFill::Face(splineEdge(wander(draw, 0, 0, draw.count(3, 7))),
                                          splineEdge(wander(draw, apart, 1, draw.count(3, 7))));
  return draw.chance(40) ? extruded(face, gp_Vec(0, draw.between(-0.3, 0.3), 1.5))
                         : TopoDS_Shape(face);
}

/// Between four curves.
TopoDS_Shape coons(Draw& draw) {
  const gp_Pnt corners[] = {
      draw.point(0.5).Translated(gp_Vec(0, 0, 0)), draw.point(0.5).Translated(gp_Vec(5, 0, 0)),
      draw.point(0.5).Translated(gp_Vec(5, 4, 0)), draw.point(0.5).Translated(gp_Vec(0, 4, 0))};
  Handle(Geom_BSplineCurve) sides[4];
  for (int i = 0; i < 4; ++i) {
    const gp_Pnt &from = corners[i], &to = corners[(i + 1) % 4];
    std::vector<gp_Pnt> points = {from};
    const int inner = draw.count(1, 4);
    for (int k = 1; k <= inner; ++k)
      points.push_back(from.Translated(gp_Vec(from, to) * (static_cast<double>(k) / (inner + 1)) +
                                       gp_Vec(draw.point(0.5).XYZ())));
    points.push_back(to);
    double first = 0, last = 0;
    sides[i] =
        Handle(Geom_BSplineCurve)::DownCast(BRep_Tool::Curve(splineEdge(points), first, last));
  }
  const GeomFill_FillingStyle styles[] = {GeomFill_StretchStyle, GeomFill_CoonsStyle,
                                          GeomFill_CurvedStyle};
  const GeomFill_BSplineCurves fill(sides[0], sides[1], sides[2], sides[3],
                                    styles[draw.count(0, 2)]);
  return wholeFace(fill.Surface());
}

/// A strip around an axis, as in a conveyor; with a thickness or without.
TopoDS_Shape auger(Draw& draw) {
  const double inner = draw.chance(30) ? 0 : draw.between(0.1, 1), outer = draw.between(1.5, 3);
  const double pitch = draw.between(0.5, 3), turns = draw.between(0.5, 4);
  const auto helix = [&](double radius) {
    std::vector<gp_Pnt> points;
    const int count = 4 + static_cast<int>(16 * turns);
    for (int i = 0; i <= count; ++i) {
      const double turn = turns * i / count;
      points.emplace_back(radius * std::cos(kTurn * turn), radius * std::sin(kTurn * turn),
                          pitch * turn);
    }
    return splineEdge(points);
  };
  const TopoDS_Face face = BRepFill::Face(helix(inner), helix(outer));
  return draw.chance(50) ? extruded(face, gp_Vec(0, 0, draw.between(0.02, 0.3)))
                         : TopoDS_Shape(face);
}

/// Two halves of a strip that is joined to itself with half turns in it.
TopoDS_Shape strip(Draw& draw) {
  const int halfTurns = draw.count(0, 3);
  const double wide = draw.between(0.2, 1.2);
  BRepBuilderAPI_Sewing sewing(1e-3);
  for (const double start : {0.0, 0.5}) {
    sewing.Add(surfaceThrough(24, 4, [&](double u, double v) {
      const double turn = start + u / 2, tilt = kTurn / 2 * halfTurns * turn;
      const double out = 3 + wide * (2 * v - 1) * std::cos(tilt);
      return gp_Pnt(out * std::cos(kTurn * turn), out * std::sin(kTurn * turn),
                    wide * (2 * v - 1) * std::sin(tilt));
    }));
  }
  sewing.Perform();
  return sewing.SewedShape();
}

/// A cubic spline with ridges along some of its knots.
TopoDS_Shape kinked(Draw& draw) {
  const int spans = draw.count(2, 5);
  TColStd_Array1OfReal knots(1, spans + 1);
  TColStd_Array1OfInteger multiplicities(1, spans + 1);
  int poles = 4;
  for (int i = 1; i <= spans + 1; ++i) {
    knots.SetValue(i, i);
    const bool isEnd = i == 1 || i == spans + 1;
    multiplicities.SetValue(i, isEnd ? 4 : draw.count(1, 3));
    if (!isEnd) poles += multiplicities.Value(i);
  }
  TColgp_Array2OfPnt net(1, poles, 1, 4);
  for (int i = 1; i <= poles; ++i)
    for (int j = 1; j <= 4; ++j)
      net.SetValue(i, j, gp_Pnt(i + draw.between(-0.2, 0.2), j, draw.between(-0.6, 0.6)));
  TColStd_Array1OfReal ends(1, 2);
  ends.SetValue(1, 0);
  ends.SetValue(2, 1);
  TColStd_Array1OfInteger all(1, 2);
  all.Init(4);
  return wholeFace(new Geom_BSplineSurface(net, knots, ends, multiplicities, all, 3, 3));
}

/// One Bezier patch of a high degree, with weights and poles that are bunched or spread.
TopoDS_Shape highDegree(Draw& draw) {
  const int rows = draw.count(5, 16), columns = draw.count(3, 16);
  const double bunch = draw.between(0.4, 2.5), weight = draw.chance(50) ? 1 : draw.between(2, 20);
  TColgp_Array2OfPnt poles(1, rows, 1, columns);
  TColStd_Array2OfReal weights(1, rows, 1, columns);
  for (int i = 1; i <= rows; ++i)
    for (int j = 1; j <= columns; ++j) {
      const double u = std::pow((i - 1.0) / (rows - 1), bunch);
      poles.SetValue(i, j, gp_Pnt(6 * u, 4 * (j - 1.0) / (columns - 1), draw.between(-1, 1)));
      weights.SetValue(i, j, draw.between(1 / weight, weight));
    }
  return wholeFace(new Geom_BezierSurface(poles, weights));
}

/// A closed body with holes all over, also across seams and poles.
TopoDS_Shape pierced(Draw& draw) {
  std::vector<TopoDS_Shape> all;
  const int count = draw.count(3, 24);
  const double radius = draw.between(0.05, 0.35);
  for (int i = 0; i < count; ++i) {
    const double z = 1 - (2 * i + 1.0) / count, turn = 0.618034 * i;
    const gp_Dir out(std::sqrt(1 - z * z) * std::cos(kTurn * turn),
                     std::sqrt(1 - z * z) * std::sin(kTurn * turn), z);
    const gp_Ax2 axes(gp_Pnt().Translated(gp_Vec(out) * 1.7), out);
    all.push_back(BRepPrimAPI_MakeCylinder(axes, radius, 9).Shape());
  }
  const TopoDS_Shape drills = compound(all);
  switch (draw.count(0, 3)) {
    case 0:
      return cut(BRepPrimAPI_MakeSphere(3).Shape(), drills);
    case 1:
      return cut(BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(0, 0, -3), gp::DZ()), 2.2, 6).Shape(),
                 drills);
    case 2:
      return cut(BRepPrimAPI_MakeCone(gp_Ax2(gp_Pnt(0, 0, -3), gp::DZ()), 3, 0, 6).Shape(), drills);
    default:
      return cut(BRepPrimAPI_MakeTorus(3, 1).Shape(), drills);
  }
}

/// A plane face with a ragged boundary.
TopoDS_Shape ragged(Draw& draw) {
  std::vector<gp_Pnt> points;
  const double bulge = draw.between(0.1, 0.33) * (draw.chance(50) ? 1 : -1);
  const int sides = draw.count(3, 6), depth = draw.count(1, 3);
  const std::function<void(const gp_Pnt&, const gp_Pnt&, int)> add =
      [&](const gp_Pnt& from, const gp_Pnt& to, int level) {
        if (level == 0) return points.push_back(from);
        const gp_Vec along = gp_Vec(from, to) / 3;
        const gp_Vec out = gp_Vec(along.Y(), -along.X(), 0) * (3 * bulge);
        const gp_Pnt a = from.Translated(along), b = to.Translated(-along);
        const gp_Pnt tip = from.Translated(along * 1.5 + out);
        add(from, a, level - 1);
        add(a, tip, level - 1);
        add(tip, b, level - 1);
        add(b, to, level - 1);
      };
  for (int i = 0; i < sides; ++i) {
    const auto corner = [&](int k) {
      return gp_Pnt(5 * std::cos(kTurn * k / sides), 5 * std::sin(kTurn * k / sides), 0);
    };
    add(corner(i), corner(i + 1), depth);
  }
  const TopoDS_Face face = flatFace(polygon(points));
  return draw.chance(50) ? extruded(face, gp_Vec(0, 0, draw.between(0.1, 2))) : TopoDS_Shape(face);
}

/// A plate with a slot along a spiral.
TopoDS_Shape spiralSlot(Draw& draw) {
  const double turns = draw.between(1, 4), pitch = 4 / turns;
  const double wide = draw.between(0.02, 0.45) * pitch;
  std::vector<gp_Pnt> one, other;
  const int count = 6 + static_cast<int>(12 * turns);
  for (int i = 0; i <= count; ++i) {
    const double turn = turns * i / count, radius = 0.5 + pitch * turn;
    const gp_Vec out(std::cos(kTurn * turn), std::sin(kTurn * turn), 0);
    one.push_back(gp_Pnt().Translated(out * radius));
    other.push_back(gp_Pnt().Translated(out * (radius + wide)));
  }
  std::vector<gp_Pnt> points = other;
  points.insert(points.end(), one.rbegin(), one.rend());
  const TopoDS_Wire slot = draw.chance(50) ? polygon(points) : splineWire(points, Ends::Joined);
  const TopoDS_Shape plate = flatFace(circle(gp::XOY(), 6), {slot});
  return draw.chance(50) ? extruded(plate, gp_Vec(0, 0, draw.between(0.05, 1))) : plate;
}

/// Letters, more or less, on a plate or around a cylinder.
TopoDS_Shape embossed(Draw& draw) {
  const bool round = draw.chance(50);
  TopoDS_Shape shape =
      round ? BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(0, 0, -1), gp::DZ()), 3, 2).Shape()
            : BRepPrimAPI_MakeBox(gp_Pnt(-4, -1, -1), 8, 4, 2).Shape();
  const double high = draw.between(0.03, 0.3), size = draw.between(0.15, 0.5);
  const bool raised = draw.chance(60);
  for (int i = draw.count(2, 5); i > 0; --i) {
    std::vector<gp_Pnt> points;
    const int corners = draw.count(4, 9);
    for (int k = 0; k < corners; ++k) {
      const double radius = size * draw.between(0.4, 1);
      points.emplace_back(0.8 * i - 2.4 + radius * std::cos(kTurn * k / corners),
                          0.6 + radius * std::sin(kTurn * k / corners), 0);
    }
    const TopoDS_Wire outer = draw.chance(50) ? polygon(points) : splineWire(points, Ends::Joined);
    gp_Trsf place;
    // Upright in front of the cylinder, or flat on the plate.
    if (round) {
      const double front = raised ? -3 - high : -4 + high;
      place.SetDisplacement(gp::XOY(), gp_Ax3(gp_Pnt(0, front, -0.5), gp::DY(), gp::DX()));
    } else {
      place.SetTranslation(gp_Vec(0, 0, raised ? 0.5 : 1 - high));
    }
    const TopoDS_Shape letter = extruded(flatFace(outer), gp_Vec(0, 0, round ? 1 : 0.5 + high))
                                    .Moved(TopLoc_Location(place));
    shape = raised ? fused(shape, letter) : cut(shape, letter);
  }
  return shape;
}

/// Circles in a plate that almost touch each other and its border.
TopoDS_Shape nearHoles(Draw& draw) {
  const double gaps[] = {0.3, 0.1, 0.03, 0.01, 0.003, 0.001};
  std::vector<TopoDS_Wire> holes;
  double x = 0;
  const int count = draw.count(2, 6);
  double before = 0;
  double least = 9;
  for (int i = 0; i < count; ++i) {
    const double radius = draw.between(0.2, 1.5);
    x += i == 0 ? 0 : before + radius + gaps[draw.count(0, 5)];
    holes.push_back(circle(gp_Ax2(gp_Pnt(x, radius, 0), gp::DZ()), radius));
    before = radius;
    if (i == 0) least = -radius - gaps[draw.count(0, 5)];
  }
  const double low = -gaps[draw.count(0, 5)], most = x + before + gaps[draw.count(0, 5)];
  const TopoDS_Face plate = flatFace(polygon({gp_Pnt(least, low, 0), gp_Pnt(most, low, 0),
                                              gp_Pnt(most, 3.5, 0), gp_Pnt(least, 3.5, 0)}),
                                     holes);
  return draw.chance(40) ? extruded(plate, gp_Vec(0, 0, draw.between(0.1, 1)))
                         : TopoDS_Shape(plate);
}

}  // namespace

std::vector<Family> ornateFamilies() {
  return {{"ruled", ruled},       {"coons", coons},         {"auger", auger},
          {"strip", strip},       {"kinked", kinked},       {"high_degree", highDegree},
          {"pierced", pierced},   {"ragged", ragged},       {"spiral_slot", spiralSlot},
          {"embossed", embossed}, {"near_holes", nearHoles}};
}

}  // namespace af2::made
