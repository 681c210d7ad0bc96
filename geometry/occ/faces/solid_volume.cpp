#include "geometry/occ/faces/solid_volume.h"

#include <BRep_Tool.hxx>
#include <Standard_Failure.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <cmath>
#include <limits>

#include "engine/base/error.h"
#include "geometry/occ/base/points.h"
#include "geometry/occ/faces/curved_integral.h"
#include "geometry/occ/faces/face_area.h"

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

/// The same to any face; not a number if it cannot be computed.
double cone(const ModelShape& model, int id, const TopoDS_Face& face, const Point3& apex) {
  const FaceSurface surface = model.surface(id);
  const double sign = face.Orientation() == TopAbs_REVERSED ? -1 : 1;
  if (!surface.isPlane())
    return sign *
           curvedCone(TopoDS::Face(face.Oriented(TopAbs_FORWARD)), surface, apex, model.diagonal);
  const SurfaceFrame frame = surface.inOccParameters().frameAt(0, 0);
  const double area = areaOf(model, id);
  if (area == 0) return kUnknown;
  return sign * area * dot(frame.position - apex, unit(cross(frame.du, frame.dv)));
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
      for (TopExp_Explorer it(solid.Current(), TopAbs_FACE); it.More(); it.Next())
        sum += cone(model, model.faces.FindIndex(it.Current()), TopoDS::Face(it.Current()), apex);
    if (std::isfinite(sum)) return sum / 3;
  } catch (const GeometryError&) {  // a face has no surface
  } catch (const Standard_Failure&) {
  }
  return std::nullopt;
}

}  // namespace af2::geometry
