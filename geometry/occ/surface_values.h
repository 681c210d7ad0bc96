// Position and derivatives of a CAD surface: from tables of our own for splines, from OpenCASCADE
// for the others. Not installed: includers need OpenCASCADE's headers.
#pragma once

#include <GeomAdaptor_Surface.hxx>
#include <memory>
#include <optional>

#include "geometry/spline_surface.h"

namespace af2::geometry {

/// A surface as the definition of a spline, if it is one, or extruded from one. An extrusion is
/// linear along its direction; as a spline it reaches from box.v1 to box.v2.
std::optional<SplineDefinition> splineDefinitionOf(const GeomAdaptor_Surface& surface,
                                                   const SplineSurface::Box& box);

/// Not to be used from two threads at once: OpenCASCADE keeps the polynomials of the last patch.
/// Copies share them.
class SurfaceValues {
 public:
  /// box  where the surface is wanted; elsewhere it may take longer
  SurfaceValues(const Handle(Geom_Surface) & surface, const SplineSurface::Box& box);

  SurfaceFrame frameAt(double u, double v) const;
  SurfaceJet jetAt(double u, double v) const;

 private:
  std::shared_ptr<const GeomAdaptor_Surface> adaptor_;
  std::shared_ptr<const SplineSurface> spline_;
};

}  // namespace af2::geometry
