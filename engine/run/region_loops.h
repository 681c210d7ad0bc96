// The loops of a region before and after it is cut. Not installed.
#pragma once

#include <cstddef>
#include <vector>

#include "engine/run/region_cuts.h"

namespace af2::region {

/// In the parameter plane; positive if the loop runs counter-clockwise.
double signedArea(const Loop& loop, const Plane& plane);

/// Relinks the loops along the cuts: at each end of a cut the incoming edge continues along it.
///
/// firstCutVertex  the id of the first inner vertex of the first cut; the others follow
Loops relink(const Loops& loops, const std::vector<Cut>& cuts, std::size_t firstCutVertex);

/// Outer loops, each with the holes inside it; no value if a hole lies in none of them.
///
/// isReversed  whether outer loops run clockwise
std::vector<Loops> regionsOf(Loops loops, const Plane& plane, bool isReversed);

}  // namespace af2::region
