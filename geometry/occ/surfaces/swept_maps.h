// Maps extrusions and surfaces of revolution to the plane.
// Not installed: includers need OpenCASCADE's headers.
#pragma once

#include <memory>

#include "geometry/charts/length_table.h"
#include "geometry/charts/plane_map.h"
#include "geometry/charts/spline_extrusion.h"
#include "geometry/charts/unrolled_surfaces.h"
#include "geometry/occ/surfaces/general_surface.h"

namespace af2::geometry {

/// An isometry: x is the length of the curve perpendicular to the direction of extrusion, y the
/// length along it. Null if the curve is parallel to the direction somewhere. The map keeps a
/// reference to `surface`.
///
/// box  the part of the parameters that is laid out
std::unique_ptr<PlaneMap> makeExtrusionMap(const GeneralSurface& surface,
                                           const SplineSurface::Box& box,
                                           const Extrusion& extrusion);

/// Conformal: x is proportional to the angle around the axis, y to the integral of ds / r along the
/// meridian, with s the length and r the distance from the axis. Null if the surface comes near the
/// axis. The map keeps a reference to `surface`.
///
/// onAxis, axis  the latter of unit length
std::unique_ptr<PlaneMap> makeRevolutionMap(const GeneralSurface& surface,
                                            const SplineSurface::Box& box, const Point3& onAxis,
                                            const Point3& axis);

}  // namespace af2::geometry
