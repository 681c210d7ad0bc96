// Completes faces that are a whole closed surface but lack a proper boundary.
#pragma once

#include "geometry/occ/model/model_shape.h"

namespace af2::geometry {

/// Adds seams and poles to faces without any edge, and to faces of surfaces that are closed in both
/// directions, such as tori, whose edges are on the seams and enclose nothing. Notes report how
/// many.
///
/// The latter are whole tori in IGES files: all corners of the boundary are the same point in
/// space, so its sides are often written in a wrong order, and read as the same side in both
/// directions.
void giveWholeBoundaries(ReadShape& read);

}  // namespace af2::geometry
