#include "geometry/occ/surfaces/flat_surfaces.h"

#include <GeomAdaptor_Surface.hxx>
#include <GeomLib_IsPlanarSurface.hxx>
#include <Geom_SurfaceOfLinearExtrusion.hxx>
#include <Geom_TrimmedCurve.hxx>
#include <Precision.hxx>

namespace af2::geometry {

namespace {

bool mayBeFlat(GeomAbs_SurfaceType type) { return type >= GeomAbs_BezierSurface; }

/// An extrusion of a curve without ends, such as a hyperbola, within the box; any other surface
/// itself. The far ends of a hyperbola have no coordinates.
Handle(Geom_Surface) withEnds(const Handle(Geom_Surface) & surface, const SplineSurface::Box& box) {
  const auto extrusion = Handle(Geom_SurfaceOfLinearExtrusion)::DownCast(surface);
  if (extrusion.IsNull()) return surface;
  const Handle(Geom_Curve) curve = extrusion->BasisCurve();
  if (!Precision::IsInfinite(curve->FirstParameter()) || !(box.u1 < box.u2)) return surface;
  return new Geom_SurfaceOfLinearExtrusion(new Geom_TrimmedCurve(curve, box.u1, box.u2),
                                           extrusion->Direction());
}

}  // namespace

bool isFlat(const Handle(Geom_Surface) & surface, const SplineSurface::Box& box, double extent) {
  constexpr double kFlat = 1e-7;  // of the extent
  return mayBeFlat(GeomAdaptor_Surface(surface).GetType()) &&
         GeomLib_IsPlanarSurface(withEnds(surface, box), kFlat * extent).IsPlanar();
}

}  // namespace af2::geometry
