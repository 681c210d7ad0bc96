// Finds creases: lines of constant u or v inside a face at which it turns sharply, like at an edge.
// Not installed: includers need OpenCASCADE's headers.
#pragma once

#include <Geom_Surface.hxx>

#include "geometry/occ/surfaces/face_cells.h"
#include "geometry/occ/surfaces/general_surface.h"

namespace af2::geometry {

/// Finds creases along the whole of a face: where the normal turns by more than about 30 degrees at
/// once, as on a spline at a knot of full multiplicity, or within a few hundredths of the wanted
/// size. Also finds pinches, where the face shrinks to a point and continues.
///
/// box   the part of the parameters that the face occupies
/// size  of elements; if not positive, only jumps of the normal count
///
/// Nothing in both directions if there are none.
FaceCells cellsOf(const GeneralSurface& surface, const Handle(Geom_Surface) & definition,
                  const SplineSurface::Box& box, double size);

}  // namespace af2::geometry
