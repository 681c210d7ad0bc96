#include "geometry/occ/faces/solid_volume.h"

#include <BRep_Tool.hxx>
#include <ElCLib.hxx>
#include <GeomAdaptor_Surface.hxx>
#include <Standard_Failure.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <cmath>
#include <gp_Cone.hxx>
#include <gp_Cylinder.hxx>
#include <gp_Lin.hxx>
#include <gp_Sphere.hxx>
#include <limits>
#include <optional>

#include "engine/base/error.h"
#include "geometry/occ/base/points.h"
#include "geometry/occ/faces/curved_integral.h"
#include "geometry/occ/faces/face_area.h"
#include "geometry/occ/faces/projected_area.h"

namespace af2::geometry {

namespace {

constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

/// Three times the volume of the cone from a point to a curved face.
double curvedCone(const TopoDS_Face& face, const FaceSurface& surface, const Point3& apex,
                  double extent) {
  constexpr double kFar = std::numeric_limits<double>::infinity();
  const Stretch all{-kFar, kFar, -kFar, kFar};
  const double perStrip = kShare * widthOfBox(surface) * extent;
  const auto density = [&](const SurfaceFrame& frame) {
    return dot(frame.position - apex, cross(frame.du, frame.dv));
  };
  CurvedIntegral integral(face, surface.box(), summedStrips(face, surface, density, perStrip),
                          perStrip, all, all);
  addBoundary(face, integral);
  return integral.isClosed() ? integral.sum() : kUnknown;
}

/// A surface whose tangent planes are all as far from some point: a cylinder, cone or sphere.
struct EvenlyFar {
  Point3 centre;        ///< of all such points that nearest to the apex
  double distance = 0;  ///< to that side to which du x dv points
};

std::optional<EvenlyFar> evenlyFar(const TopoDS_Face& face, const Point3& apex) {
  const GeomAdaptor_Surface surface(BRep_Tool::Surface(face));
  const auto outward = [](const gp_Ax3& at) { return at.Direct() ? 1. : -1.; };
  switch (surface.GetType()) {
    case GeomAbs_Cylinder: {
      const gp_Cylinder cylinder = surface.Cylinder();
      const gp_Lin axis(cylinder.Axis());
      return EvenlyFar{toPoint(ElCLib::Value(ElCLib::Parameter(axis, toOcc(apex)), axis)),
                       outward(cylinder.Position()) * cylinder.Radius()};
    }
    case GeomAbs_Cone:
      return EvenlyFar{toPoint(surface.Cone().Apex()), 0};
    case GeomAbs_Sphere: {
      const gp_Sphere sphere = surface.Sphere();
      return EvenlyFar{toPoint(sphere.Location()), outward(sphere.Position()) * sphere.Radius()};
    }
    default:
      return std::nullopt;
  }
}

/// The same to any face that is not reversed; not a number if it cannot be computed.
double cone(const ModelShape& model, int id, const TopoDS_Face& face, const Point3& apex) {
  const FaceSurface surface = model.surface(id);
  const std::optional<EvenlyFar> far = evenlyFar(face, apex);
  // Of what is far larger than the model, the area and the edges tell nearly the same twice, with
  // opposite signs.
  constexpr double kMostAway = 10;  // diagonals
  const bool isNear = far && distance(far->centre, apex) < kMostAway * model.diagonal;
  if (!surface.isPlane() && !isNear) return curvedCone(face, surface, apex, model.diagonal);
  const double area = areaOf(model, id);
  if (area == 0) return kUnknown;
  if (surface.isPlane()) {
    const SurfaceFrame frame = surface.inOccParameters().frameAt(0, 0);
    return area * dot(frame.position - apex, unit(cross(frame.du, frame.dv)));
  }
  ProjectedArea towardsCentre(far->centre - apex);
  addBoundary(face, towardsCentre);
  return far->distance * area + towardsCentre.sum();
}

/// Where the model is, so that the cones are no larger than it.
Point3 apexOf(const ModelShape& model) {
  return model.vertices.IsEmpty() ? Point3{} : toPoint(BRep_Tool::Pnt(model.vertex(1)));
}

}  // namespace

std::optional<double> volumeOfSolids(const ModelShape& model) {
  if (TopExp_Explorer(model.shape, TopAbs_FACE, TopAbs_SOLID).More()) return std::nullopt;
  try {
    const Point3 apex = apexOf(model);
    double sum = 0;
    for (TopExp_Explorer solid(model.shape, TopAbs_SOLID); solid.More(); solid.Next())
      for (TopExp_Explorer it(solid.Current(), TopAbs_FACE); it.More(); it.Next()) {
        const TopoDS_Face forward = TopoDS::Face(it.Current().Oriented(TopAbs_FORWARD));
        const double sign = it.Current().Orientation() == TopAbs_REVERSED ? -1 : 1;
        sum += sign * cone(model, model.faces.FindIndex(it.Current()), forward, apex);
      }
    if (std::isfinite(sum)) return sum / 3;
  } catch (const GeometryError&) {  // a face has no surface
  } catch (const Standard_Failure&) {
  }
  return std::nullopt;
}

}  // namespace af2::geometry
