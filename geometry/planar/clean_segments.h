// Makes segments meet at their ends only.
#pragma once

#include "geometry/planar/loops.h"

namespace af2::geometry {

/// Fills points, pieces and what is said of points, not the regions. What is nearer than `blur` is
/// the same. Throws InputError if segments cross.
PlanarRegions cleanSegments(const PlanarDomain& domain, double blur);

}  // namespace af2::geometry
