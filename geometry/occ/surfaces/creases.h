// Lines of constant u or v at which a face turns sharply inside: edges in all but name.
// Not installed: includers need OpenCASCADE's headers.
#pragma once

#include <Geom_Surface.hxx>

#include "geometry/occ/surfaces/face_cells.h"
#include "geometry/occ/surfaces/general_surface.h"

namespace af2::geometry {

/// Finds creases all along a face: where the normal turns by more than some 30 degrees at once, as
/// a spline does at a knot of full multiplicity, and by more than a radian within a few hundredths
/// of the wanted size. And pinches, where it goes on from tip to tip.
///
/// box   the part of the parameters that the face takes up
/// size  of elements; not positive: only what turns at once counts
///
/// Nothing in both directions if there are none.
FaceCells cellsOf(const GeneralSurface& surface, const Handle(Geom_Surface) & definition,
                  const SplineSurface::Box& box, double size);

}  // namespace af2::geometry
