// Finds edges and faces that overlap, by the criteria of meshing.
#pragma once

#include <vector>

#include "geometry/mesh/defect.h"
#include "geometry/occ/model/model.h"

namespace af2::geometry {

/// Edges and faces that a mesh of the given size would merge: edges with the same ends, or parts of
/// them, and faces that occur twice or overlap others with which they share edges.
std::vector<Defect> findOverlaps(const Model& model, double size);

}  // namespace af2::geometry
