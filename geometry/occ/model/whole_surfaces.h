// Faces that are all of a closed surface, but come without the boundary that says so.
#pragma once

#include "geometry/occ/model/model_shape.h"

namespace af2::geometry {

/// Gives seams and poles to faces without any edge, and to faces of surfaces closed both ways, as
/// tori are, whose edges lie on the seams and enclose nothing. Notes tell how many.
///
/// The latter are whole tori as IGES files have them: all corners of the boundary are the same
/// point in space, so that its sides are easily written in a wrong order, and read as the same one
/// to and fro.
void giveWholeBoundaries(ReadShape& read);

}  // namespace af2::geometry
