// Two triangles with quadrilaterals between them become quadrilaterals.
#pragma once

#include "engine/base/work_watch.h"
#include "engine/optimize/quad_changes.h"

namespace af2 {

/// Moves one triangle through adjacent quadrilaterals to another triangle, where the two become one
/// quadrilateral. Each quadrilateral on the way gets another outline; no vertex is added or
/// removed. Done only where that lowers the total cost. Ends early if a stop is requested. Returns
/// the number of pairs.
std::size_t pairTriangles(QuadChanges& changes, const WorkWatch& watch = {});

}  // namespace af2
