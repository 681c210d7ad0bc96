// Position and derivatives of a CAD surface: from tables of our own for splines, from OpenCASCADE
// for the others. Not installed: includers need OpenCASCADE's headers.
#pragma once

#include <GeomAdaptor_Surface.hxx>
#include <memory>
#include <optional>

#include "geometry/charts/spline_surface.h"

namespace af2::geometry {

/// The spline definition of a surface, if it is a spline or extruded from one. An extrusion is
/// linear along its direction; as a spline it extends from box.v1 to box.v2.
std::optional<SplineDefinition> splineDefinitionOf(const GeomAdaptor_Surface& surface,
                                                   const SplineSurface::Box& box);

/// Must not be used from two threads at once, because OpenCASCADE's evaluators cache their last
/// result. Each thread may have a copy; copies share only the tables.
class SurfaceValues {
 public:
  /// box  where the surface is needed; evaluation elsewhere may be slower
  SurfaceValues(const Handle(Geom_Surface) & surface, const SplineSurface::Box& box);
  SurfaceValues(const SurfaceValues& other);
  SurfaceValues(SurfaceValues&&) = default;
  SurfaceValues& operator=(const SurfaceValues& other) { return *this = SurfaceValues(other); }
  SurfaceValues& operator=(SurfaceValues&&) = default;

  SurfaceFrame frameAt(double u, double v) const;
  SurfaceJet jetAt(double u, double v) const;

 private:
  Handle(Geom_Surface) surface_;
  std::shared_ptr<const SplineSurface> spline_;   ///< null: there is none
  std::unique_ptr<GeomAdaptor_Surface> adaptor_;  ///< without a spline
};

}  // namespace af2::geometry
