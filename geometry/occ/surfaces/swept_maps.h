// Extrusions and surfaces of revolution laid out in the plane.
// Not installed: includers need OpenCASCADE's headers.
#pragma once

#include <memory>

#include "geometry/charts/length_table.h"
#include "geometry/charts/plane_map.h"
#include "geometry/charts/spline_extrusion.h"
#include "geometry/charts/unrolled_surfaces.h"
#include "geometry/occ/surfaces/general_surface.h"

namespace af2::geometry {

/// An isometry: x is the length of the curve across the direction of extrusion, y that along it.
/// Null if the curve runs along the direction somewhere. The map keeps a reference to `surface`.
///
/// box  the part of the parameters that is laid out
std::unique_ptr<PlaneMap> makeExtrusionMap(const GeneralSurface& surface,
                                           const SplineSurface::Box& box,
                                           const Extrusion& extrusion);

/// Conformal: x goes with the angle around the axis, y with the integral of the length along the
/// meridian over the distance from the axis. Null if the surface comes near the axis. The map keeps
/// a reference to `surface`.
///
/// onAxis, axis  the latter of unit length
std::unique_ptr<PlaneMap> makeRevolutionMap(const GeneralSurface& surface,
                                            const SplineSurface::Box& box, const Point3& onAxis,
                                            const Point3& axis);

}  // namespace af2::geometry
