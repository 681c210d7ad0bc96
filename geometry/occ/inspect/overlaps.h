// Edges and faces that lie on each other, as meshing sees them.
#pragma once

#include <vector>

#include "geometry/mesh/defect.h"
#include "geometry/occ/model/model.h"

namespace af2::geometry {

/// Those that a mesh of the given size would take for one: edges with the same ends, or parts of
/// them, and faces that are there twice or lie on others with which they have edges in common.
std::vector<Defect> findOverlaps(const Model& model, double size);

}  // namespace af2::geometry
