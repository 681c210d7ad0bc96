// Improves a complete mesh by the metric of its rule set: swaps and moves of vertices.
#pragma once

#include "engine/optimize/finish_mesh.h"

namespace af2 {

/// Lowers the badness of the elements, in place, and never raises the worst one.
///
/// A side between two triangles is swapped only if the worse of the two new triangles is better
/// than the worse of the old ones. An inner vertex moves only if the worst badness around it falls,
/// or stays the same while the sum falls. Elements that are all ideal therefore stay as they are.
/// No vertex or element is added or removed. Quadrilaterals are only smoothed.
///
/// Uses of the options: `rounds`, `smoothingSweeps`, `keepOriginal` and `stop`.
OptimizeReport finishByScore(Mesh& mesh, const MeshBoundary& boundary, const FinishTask& task,
                             const OptimizeOptions& options);

}  // namespace af2
