// Splits and merges segments so that they meet only at their ends.
#pragma once

#include "geometry/planar/loops.h"

namespace af2::geometry {

/// Sets the points, their properties and the pieces, but not the regions. Points nearer than `blur`
/// are merged. Throws InputError if segments cross.
PlanarRegions cleanSegments(const PlanarDomain& domain, double blur);

}  // namespace af2::geometry
