#include "geometry/occ/faces/face_area.h"

#include <BRepAdaptor_Curve.hxx>
#include <BRep_Tool.hxx>
#include <GeomAdaptor_Surface.hxx>
#include <Precision.hxx>
#include <Standard_Failure.hxx>
#include <TopExp.hxx>
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "engine/base/elementary.h"
#include "engine/base/error.h"
#include "geometry/occ/base/points.h"
#include "geometry/occ/faces/curved_integral.h"
#include "geometry/occ/surfaces/face_surface.h"

namespace af2::geometry {

namespace {

/// Strips of the surfaces whose parameters are at right angles: as high everywhere as they are at
/// v.
std::optional<Strip> closedForm(const GeomAdaptor_Surface& surface, const SplineSurface::Box& box) {
  const double from = (box.u1 + box.u2) / 2;
  switch (surface.GetType()) {
    case GeomAbs_Cylinder:
      return [=, r = surface.Cylinder().Radius()](double u, double) { return r * (u - from); };
    case GeomAbs_Sphere:
      return [=, r = surface.Sphere().Radius()](double u, double v) {
        return r * r * cosine(v) * (u - from);
      };
    case GeomAbs_Cone: {
      const double r = surface.Cone().RefRadius(), sine = af2::sine(surface.Cone().SemiAngle());
      if ((r + box.v1 * sine) * (r + box.v2 * sine) < 0) return std::nullopt;  // on both nappes
      return [=](double u, double v) { return (r + v * sine) * (u - from); };
    }
    case GeomAbs_Torus: {
      const double major = surface.Torus().MajorRadius(), minor = surface.Torus().MinorRadius();
      if (minor > major) return std::nullopt;
      return [=](double u, double v) { return minor * (major + minor * cosine(v)) * (u - from); };
    }
    default:
      return std::nullopt;
  }
}

/// 0 if some wire is not closed in the parameters, or if the curves there may lie beside the edges
/// by more than the face is wide.
double curvedArea(const TopoDS_Face& face, const FaceSurface& surface, const Stretch& u,
                  const Stretch& v) {
  const double perStrip = kShare * widthOfBox(surface);
  std::optional<Strip> strip =
      closedForm(GeomAdaptor_Surface(BRep_Tool::Surface(face)), surface.box());
  if (!strip)
    strip = summedStrips(
        face, surface, [](const SurfaceFrame& frame) { return length(cross(frame.du, frame.dv)); },
        perStrip);
  CurvedIntegral integral(face, surface.box(), std::move(*strip), perStrip, u, v);
  addBoundary(face, integral);
  const double area = std::abs(integral.sum());
  return integral.isClosed() && area > integral.doubt() ? area : 0;
}

/// In a plane, the triangles from some point to the boundary. The edges are taken in space: many
/// files have no curves in the parameters of planes, and to make them takes long.
class PlaneArea {
 public:
  explicit PlaneArea(const Point3& normal) : normal_(normal) {}

  void add(const TopoDS_Edge& edge) {
    if (BRep_Tool::Degenerated(edge)) return;
    const BRepAdaptor_Curve curve(edge);
    const Point3 start = toPoint(curve.Value(curve.FirstParameter()));
    const Point3 end = toPoint(curve.Value(curve.LastParameter()));
    const Point3 middle =
        toPoint(curve.Value((curve.FirstParameter() + curve.LastParameter()) / 2));
    if (!origin_) origin_ = start;
    extent_ = std::max({extent_, distance(middle, *origin_), distance(end, *origin_)});
    sum_ += signOf(edge) * (triangles(curve, start, end) + gaps(edge, start, end));
  }

  void endWire() {}
  double area() const { return std::abs(sum_); }

 private:
  double between(const Point3& p, const Point3& d) const {
    return dot(cross(p - *origin_, d), normal_) / 2;
  }

  /// From the first vertex to the curve, and from the curve to the last one: they may lie apart.
  double gaps(const TopoDS_Edge& edge, const Point3& start, const Point3& end) const {
    const TopoDS_Edge forward = TopoDS::Edge(edge.Oriented(TopAbs_FORWARD));
    const TopoDS_Vertex first = TopExp::FirstVertex(forward), last = TopExp::LastVertex(forward);
    if (first.IsNull() || last.IsNull()) return 0;
    const Point3 from = toPoint(BRep_Tool::Pnt(first)), to = toPoint(BRep_Tool::Pnt(last));
    return between(from, start - from) + between(end, to - end);
  }

  double triangles(const BRepAdaptor_Curve& curve, const Point3& start, const Point3& end) const {
    if (curve.GetType() == GeomAbs_Line) return between(start, end - start);
    return integrateAlong(curve, Integral(kShare * extent_ * extent_), [&](double t) {
      gp_Pnt place;
      gp_Vec tangent;
      curve.D1(t, place, tangent);
      return between(toPoint(place), toPoint(tangent));
    });
  }

  Point3 normal_;
  std::optional<Point3> origin_;
  double sum_ = 0, extent_ = 0;
};

double areaOf(const TopoDS_Face& face, const FaceSurface& surface, const Stretch& u,
              const Stretch& v) {
  if (!surface.isPlane()) return curvedArea(face, surface, u, v);
  PlaneArea area(surface.pointAt({}, 0, 0).normal);
  addBoundary(face, area);
  return area.area();
}

}  // namespace

double areaOf(const ModelShape& model, int face) {
  constexpr double kFar = std::numeric_limits<double>::infinity();
  const Stretch all{-kFar, kFar, -kFar, kFar};
  return areaOf(model, face, all, all);
}

double areaOf(const ModelShape& model, int face, const Stretch& u, const Stretch& v) {
  try {
    const TopoDS_Face forward = TopoDS::Face(model.face(face).Oriented(TopAbs_FORWARD));
    const double area = areaOf(forward, model.surface(face), u, v);
    return area < Precision::Infinite() ? area : 0;  // no boundary, or not a number
  } catch (const GeometryError&) {                   // no surface
    return 0;
  } catch (const Standard_Failure&) {
    return 0;
  }
}

}  // namespace af2::geometry
