#include "geometry/occ/faces/projected_area.h"

#include <BRep_Tool.hxx>
#include <TopExp.hxx>
#include <TopoDS.hxx>
#include <algorithm>

#include "geometry/occ/base/points.h"
#include "geometry/occ/faces/boundary_integral.h"

namespace af2::geometry {

void ProjectedArea::add(const TopoDS_Edge& edge) {
  if (BRep_Tool::Degenerated(edge)) return;
  const BRepAdaptor_Curve curve(edge);
  const auto at = [&](double t) { return toPoint(curve.Value(t)); };
  const double first = curve.FirstParameter(), last = curve.LastParameter();
  const Point3 start = at(first), middle = at((first + last) / 2), end = at(last);
  if (!origin_) origin_ = start;
  extent_ = std::max({extent_, distance(middle, *origin_), distance(end, *origin_)});
  sum_ += signOf(edge) * (triangles(curve, start, end) + gaps(edge, start, end));
}

double ProjectedArea::between(const Point3& p, const Point3& d) const {
  return dot(cross(p - *origin_, d), direction_) / 2;
}

/// From the first vertex to the curve, and from the curve to the last one: they may lie apart.
double ProjectedArea::gaps(const TopoDS_Edge& edge, const Point3& start, const Point3& end) const {
  const TopoDS_Edge forward = TopoDS::Edge(edge.Oriented(TopAbs_FORWARD));
  const TopoDS_Vertex first = TopExp::FirstVertex(forward), last = TopExp::LastVertex(forward);
  if (first.IsNull() || last.IsNull()) return 0;
  const Point3 from = toPoint(BRep_Tool::Pnt(first)), to = toPoint(BRep_Tool::Pnt(last));
  return between(from, start - from) + between(end, to - end);
}

double ProjectedArea::triangles(const BRepAdaptor_Curve& curve, const Point3& start,
                                const Point3& end) const {
  if (curve.GetType() == GeomAbs_Line) return between(start, end - start);
  const double tolerance = kShare * extent_ * extent_ * length(direction_);
  return integrateAlong(curve, Integral(tolerance), [&](double t) {
    gp_Pnt place;
    gp_Vec tangent;
    curve.D1(t, place, tangent);
    return between(toPoint(place), toPoint(tangent));
  });
}

}  // namespace af2::geometry
