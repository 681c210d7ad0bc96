// Faces that turn sharply inside: where a spline has a kink, or a radius far below any element.
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepBuilderAPI_NurbsConvert.hxx>
#include <BRepOffsetAPI_ThruSections.hxx>
#include <BRepPrimAPI_MakeRevol.hxx>
#include <GC_MakeArcOfCircle.hxx>
#include <GC_MakeSegment.hxx>
#include <GeomConvert_CompCurveToBSplineCurve.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Geom_TrimmedCurve.hxx>
#include <Precision.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColgp_Array2OfPnt.hxx>
#include <TopoDS.hxx>
#include <cmath>
#include <gp_Ax1.hxx>
#include <numbers>

#include "tests/corpus/made/families.h"
#include "tests/corpus/made/shapes.h"

namespace af2::made {
namespace {

constexpr double kTurn = 2 * std::numbers::pi;

/// The corners cut by arcs of a radius, all of it one spline; radius 0: a spline with kinks.
TopoDS_Wire cornersAsSpline(const std::vector<gp_Pnt>& corners, double radius) {
  GeomConvert_CompCurveToBSplineCurve joined(Convert_QuasiAngular);
  const auto add = [&](const Handle(Geom_TrimmedCurve) & piece) { joined.Add(piece, 1e-6, true); };
  const std::size_t n = corners.size();
  std::vector<gp_Pnt> starts, ends;  // of the arc at each corner
  for (std::size_t i = 0; i < n; ++i) {
    const gp_Vec before(corners[i], corners[(i + n - 1) % n]),
        after(corners[i], corners[(i + 1) % n]);
    const double cut = radius / std::tan(before.Angle(after) / 2);
    starts.push_back(corners[i].Translated(before.Normalized() * cut));
    ends.push_back(corners[i].Translated(after.Normalized() * cut));
  }
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t next = (i + 1) % n;
    add(GC_MakeSegment(ends[i], starts[next]).Value());
    if (!(radius > 0)) continue;
    const gp_Vec tangent(ends[i], starts[next]);
    add(GC_MakeArcOfCircle(starts[next], tangent, ends[next]).Value());
  }
  return BRepBuilderAPI_MakeWire(BRepBuilderAPI_MakeEdge(joined.BSplineCurve()).Edge()).Wire();
}

std::vector<gp_Pnt> ring(Draw& draw, double radius, double height) {
  const int count = draw.count(3, 7);
  const double phase = draw.between(0, 1);
  std::vector<gp_Pnt> corners;
  for (int i = 0; i < count; ++i) {
    const double angle = kTurn * (i + phase) / count;
    const double r = radius * draw.between(0.7, 1.2);
    corners.emplace_back(r * std::cos(angle), r * std::sin(angle), height);
  }
  return corners;
}

TopoDS_Shape maybeSplines(Draw& draw, const TopoDS_Shape& shape) {
  return draw.chance(50) ? BRepBuilderAPI_NurbsConvert(shape).Shape() : shape;
}

double smallRadius(Draw& draw) { return draw.chance(50) ? 0 : draw.between(0.0005, 0.004); }

/// Sides that are one face: with kinks, or with corners rounded far below the size.
TopoDS_Shape prismOfOneSide(Draw& draw) {
  const TopoDS_Face base = flatFace(cornersAsSpline(ring(draw, 2, 0), smallRadius(draw)));
  TopoDS_Shape shape = extruded(base, gp_Vec(draw.between(-1, 1), 0, draw.between(0.5, 4)));
  if (draw.chance(40)) shape = cut(shape, primitive(draw, draw.between(0.5, 2)));
  return maybeSplines(draw, shape);
}

/// A ring with a polygon as its section, its sides one face.
TopoDS_Shape turnedPolygon(Draw& draw) {
  const TopoDS_Face base = flatFace(cornersAsSpline(ring(draw, 1, 0), smallRadius(draw)));
  const gp_Ax1 axis(gp_Pnt(draw.between(1.6, 4), 0, 0), gp::DY());
  return maybeSplines(
      draw,
      BRepPrimAPI_MakeRevol(base, axis, draw.chance(50) ? kTurn : draw.between(0.5, 5)).Shape());
}

/// One side of a hull: keel, chine and deck in one spline surface, the chine fading towards the
/// bow.
TopoDS_Shape hull(Draw& draw) {
  constexpr int kStations = 6;
  const double beam = draw.between(0.8, 1.6), depth = draw.between(0.6, 1.4);
  const double flare = draw.between(-0.1, 0.5), chine = draw.between(0.2, 0.6);
  const bool both = draw.chance(50);
  const int lines = both ? 7 : 4;
  TColgp_Array2OfPnt poles(1, lines, 1, kStations);
  for (int j = 0; j < kStations; ++j) {
    const double along = j / (kStations - 1.0);
    const double wide = beam * (1 - 0.92 * along * along * along);
    const gp_Pnt half[] = {gp_Pnt(8 * along, 0, 0),
                           gp_Pnt(8 * along, wide, depth * chine * (1 - 0.5 * along)),
                           gp_Pnt(8 * along, wide * (1 + flare / 2), depth * (0.5 + chine / 2)),
                           gp_Pnt(8 * along, wide * (1 + flare), depth)};
    for (int i = 0; i < lines; ++i) {
      const int k = both ? std::abs(i - 3) : i;
      const gp_Pnt& p = half[k];
      poles.SetValue(i + 1, j + 1, both && i < 3 ? gp_Pnt(p.X(), -p.Y(), p.Z()) : p);
    }
  }
  TColStd_Array1OfReal knotsU(1, lines), knotsV(1, 4);
  TColStd_Array1OfInteger timesU(1, lines), timesV(1, 4);
  for (int i = 1; i <= lines; ++i) knotsU(i) = i, timesU(i) = i == 1 || i == lines ? 2 : 1;
  for (int i = 1; i <= 4; ++i) knotsV(i) = i, timesV(i) = i == 1 || i == 4 ? 4 : 1;
  timesV(2) = 1, timesV(3) = 1;
  const Handle(Geom_BSplineSurface) surface =
      new Geom_BSplineSurface(poles, knotsU, knotsV, timesU, timesV, 1, 3);
  return BRepBuilderAPI_MakeFace(surface, Precision::Confusion()).Face();
}

/// The upper and the lower side in one face, with a sharp edge in front.
TopoDS_Shape wing(Draw& draw) {
  const double taper = draw.between(0.3, 1), sweep = draw.between(-0.5, 2);
  const double radius = smallRadius(draw), thick = draw.between(0.06, 0.2);
  BRepOffsetAPI_ThruSections sections(true, true, 1e-6);
  for (const double along : {0.0, 1.0}) {
    const double chord = 2 * (1 - (1 - taper) * along);
    std::vector<gp_Pnt> corners;
    for (const auto& [x, z] :
         {std::pair(1.0, 0.0), {0.4, 1.0}, {-0.5, 1.0}, {-1.0, 0.0}, {0.0, -0.5}})
      corners.emplace_back(chord * x + sweep * along, 5 * along, chord * thick * z);
    sections.AddWire(cornersAsSpline(corners, radius));
  }
  return sections.Shape();
}

}  // namespace

std::vector<Family> creasedFamilies() {
  return {{"prism_of_one_side", prismOfOneSide},
          {"turned_polygon", turnedPolygon},
          {"hull", hull},
          {"wing", wing}};
}

}  // namespace af2::made
