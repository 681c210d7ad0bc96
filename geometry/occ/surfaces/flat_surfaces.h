// Whether a surface is a plane, though it is written as another kind.
// Not installed: includers need OpenCASCADE's headers.
#pragma once

#include <Geom_Surface.hxx>

#include "geometry/charts/spline_surface.h"

namespace af2::geometry {

/// Whether a spline, swept or offset surface is a plane. Parameters may be degenerate or fold on
/// these, and normals be noise; of a plane nothing of that matters.
///
/// box     the part of the parameters that the face occupies
/// extent  of the face
bool isFlat(const Handle(Geom_Surface) & surface, const SplineSurface::Box& box, double extent);

}  // namespace af2::geometry
