#include "geometry/occ/edges/edge_on_face.h"

#include <BRep_Tool.hxx>
#include <ElSLib.hxx>
#include <algorithm>
#include <cmath>

#include "geometry/occ/base/points.h"

namespace af2::geometry {

EdgeOnFace::EdgeOnFace(const TopoDS_Edge& edge, const TopoDS_Face& face,
                       const std::optional<gp_Pln>& plane, const SplineSurface::Box& box)
    : face_(face), plane_(plane), box_(box) {
  if (plane_) return;
  BRep_Tool::Range(edge, first_, last_);
  curve_ = BRep_Tool::CurveOnSurface(edge, face, curveFirst_, curveLast_);
}

gp_Pnt2d EdgeOnFace::at(double parameter, const Point3& position) {
  if (plane_) return inPlane(position);
  if (curve_.IsNull()) return project(position);
  return onCurve(parameter);
}

bool EdgeOnFace::isAstray(const DividedEdge& divided, const std::vector<Point3>& points,
                          const FaceSurface& surface) const {
  if (plane_ || curve_.IsNull()) return false;
  constexpr double kMax = 0.5;  // of the longest segment
  double most = 0, longest = 0;
  for (std::size_t i = 0; i < divided.points.size(); ++i) {
    const Point3& position = points[divided.points[i]];
    const gp_Pnt2d uv = onCurve(divided.parameters[i]);
    most = std::max(most,
                    distance(surface.inOccParameters().pointAt(uv.X(), uv.Y()).position, position));
    if (i > 0) longest = std::max(longest, distance(points[divided.points[i - 1]], position));
  }
  return most > kMax * longest;
}

gp_Pnt2d EdgeOnFace::onCurve(double parameter) const {
  const double t = (parameter - first_) / (last_ - first_);
  return curve_->Value(curveFirst_ + t * (curveLast_ - curveFirst_));
}

/// Many files have no curves in the parameters of planes, and to make them takes long.
gp_Pnt2d EdgeOnFace::inPlane(const Point3& position) const {
  double u, v;
  ElSLib::Parameters(*plane_, toOcc(position), u, v);
  return {u, v};
}

/// For the rare edge that lacks its curve in the parameters. Slow, and once per boundary point.
gp_Pnt2d EdgeOnFace::project(const Point3& position) {
  if (analysis_.IsNull()) analysis_ = new ShapeAnalysis_Surface(BRep_Tool::Surface(face_));
  previous_ = hasPrevious_ ? analysis_->NextValueOfUV(previous_, toOcc(position), 1e-7)
                           : analysis_->ValueOfUV(toOcc(position), 1e-7);
  hasPrevious_ = true;
  return withinBox(previous_);
}

/// On a surface that closes, the same place in the turn in which the face lies.
gp_Pnt2d EdgeOnFace::withinBox(gp_Pnt2d uv) const {
  const Handle(Geom_Surface) surface = BRep_Tool::Surface(face_);
  const auto shift = [](double value, double low, double high, double period) {
    return value - std::round((value - (low + high) / 2) / period) * period;
  };
  if (surface->IsUPeriodic()) uv.SetX(shift(uv.X(), box_.u1, box_.u2, surface->UPeriod()));
  if (surface->IsVPeriodic()) uv.SetY(shift(uv.Y(), box_.v1, box_.v2, surface->VPeriod()));
  return uv;
}

Point3 normalOnEdge(const FaceSurface& surface, const TopoDS_Face& face, const TopoDS_Edge& edge,
                    double parameter) {
  gp_Pnt2d uv;
  if (!surface.isPlane()) {
    double first, last;
    const Handle(Geom2d_Curve) curve = BRep_Tool::CurveOnSurface(edge, face, first, last);
    if (curve.IsNull()) return {};
    uv = curve->Value(parameter);
  }
  const SurfaceFrame frame = surface.inOccParameters().frameAt(uv.X(), uv.Y());
  return cross(frame.du, frame.dv);
}

}  // namespace af2::geometry
