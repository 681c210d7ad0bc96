// Two triangles with quadrilaterals between them become quadrilaterals.
#pragma once

#include "engine/optimize/quad_changes.h"

namespace af2 {

/// Lets one triangle wander through the quadrilaterals to another, side by side with the next,
/// where both become one quadrilateral: each that it passes has another outline afterwards, and no
/// vertex comes or goes. Only where that lowers the sum of all costs.
/// Returns the number of pairs.
std::size_t pairTriangles(QuadChanges& changes);

}  // namespace af2
