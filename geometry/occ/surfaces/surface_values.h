// Position and derivatives of a CAD surface: from tables of our own for splines and their offsets,
// from OpenCASCADE for the others. Not installed: includers need OpenCASCADE's headers.
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
  /// The same, but only the parts of the second derivatives along the normal are right, which tell
  /// how the surface bends. Cheaper on an offset.
  SurfaceJet bendAt(double u, double v) const;

 private:
  std::optional<SurfaceJet> offsetBendAt(double u, double v) const;

  Handle(Geom_Surface) surface_;
  std::shared_ptr<const SplineSurface> spline_;   ///< null: there is none
  double offset_ = 0;                             ///< of the surface from the spline
  std::unique_ptr<GeomAdaptor_Surface> adaptor_;  ///< unless the surface is the spline
};

}  // namespace af2::geometry
