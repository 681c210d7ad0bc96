#include "geometry/occ/faces/face_area.h"

#include <BRep_Tool.hxx>
#include <GeomAdaptor_Surface.hxx>
#include <Precision.hxx>
#include <Standard_Failure.hxx>
#include <cmath>
#include <limits>
#include <optional>

#include "engine/base/elementary.h"
#include "engine/base/error.h"
#include "geometry/occ/faces/curved_integral.h"
#include "geometry/occ/faces/projected_area.h"
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

double areaOf(const TopoDS_Face& face, const FaceSurface& surface, const Stretch& u,
              const Stretch& v) {
  if (!surface.isPlane()) return curvedArea(face, surface, u, v);
  ProjectedArea area(surface.pointAt({}, 0, 0).normal);
  addBoundary(face, area);
  return std::abs(area.sum());
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
