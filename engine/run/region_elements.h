// How many elements a region will have. Not installed.
#pragma once

#include "engine/run/region_cuts.h"

namespace af2::region {

/// An estimate from the area and the sizes along the boundary, and, where the boundary has very
/// many edges, from the sizes beside it.
///
/// isReversed  whether the region is on the right of its loops in the parameter plane
/// many        elements; regions that can hardly have so many need not be looked at closely
double expectedElements(const Loops& loops, const Plane& plane, bool isReversed,
                        const SurfaceEvaluator& surface, const SizeField& size, double many);

}  // namespace af2::region
