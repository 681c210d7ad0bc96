// Makes segments meet at their ends only.
#pragma once

#include "geometry/planar/loops.h"

namespace af2::geometry {

/// Fills points and pieces, not the regions. Throws InputError if segments cross.
PlanarRegions cleanSegments(const PlanarDomain& domain);

}  // namespace af2::geometry
