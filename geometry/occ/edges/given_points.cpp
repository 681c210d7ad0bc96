#include "geometry/occ/edges/given_points.h"

#include <BRepAdaptor_Curve.hxx>
#include <BRep_Tool.hxx>
#include <Extrema_ExtPC.hxx>
#include <algorithm>
#include <cmath>

#include "geometry/occ/base/points.h"

namespace af2::geometry {
namespace {

/// The nearest point of a curve.
CurveFoot footOf(const Point3& point, const BRepAdaptor_Curve& curve, const EdgeRange& range) {
  CurveFoot best;
  const Extrema_ExtPC extrema(toOcc(point), curve, range.first, range.last);
  if (!extrema.IsDone()) return best;
  for (int i = 1; i <= extrema.NbExt(); ++i) {
    const double away = std::sqrt(extrema.SquareDistance(i));
    if (away < best.distance) best = {extrema.Point(i).Parameter(), away};
  }
  return best;
}

}  // namespace

PlacedPoints placeOnEdge(const ModelShape& model, int edgeId, const std::vector<Point3>& points,
                         const EdgeRange& range) {
  const TopoDS_Edge edge = model.edge(edgeId);
  const BRepAdaptor_Curve curve(edge);
  const double tolerance =
      std::max({BRep_Tool::Tolerance(edge), toleranceOfPoints(range.length, points.size()),
                range.tolerance});
  return placePoints(edgeId, points, {range.first, range.last, tolerance},
                     [&](const Point3& point) { return footOf(point, curve, range); });
}

}  // namespace af2::geometry
