// Quadrilaterals with a reflex or straight corner, which some rule sets leave where fronts meet.
// Not installed.
#pragma once

#include "engine/base/export.h"
#include "engine/base/work_watch.h"
#include "engine/mesh/mesh.h"
#include "engine/mesh/mesh_topology.h"
#include "engine/surface/local_transform.h"

namespace af2 {

/// Whether some quadrilateral does not turn left at one of its corners.
AF2_EXPORT bool hasTurnedElements(const Mesh& mesh);

/// Gives each quadrilateral that does not turn left at one of its corners a better shape: by moving
/// the vertices around it, or, if that is not enough, by joining them differently. Changes nothing
/// else. Returns the number of elements that it could not mend.
AF2_EXPORT std::size_t turnElementsRound(Mesh& mesh, const MeshBoundary& boundary,
                                         const AF2LocalTransformMaker& maker,
                                         const WorkWatch& watch);

}  // namespace af2
