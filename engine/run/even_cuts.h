// Divides cuts so that the loops around the pieces have even numbers of edges. Not installed.
#pragma once

#include <vector>

#include "engine/run/region_cuts.h"

namespace af2::region {

/// Changes the numbers of edges of cuts by at most one, so that the loops which they make become
/// even. Loops that cuts join, one after another, form a group; if the loops of a group were odd in
/// total before they were cut, one of its new loops stays odd.
void makePiecesEven(const Loops& loops, const SurfaceEvaluator& surface, const SizeField& size,
                    std::vector<Cut>& cuts);

}  // namespace af2::region
