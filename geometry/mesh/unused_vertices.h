// Removes what the elements of a mesh do not use.
// Not installed.
#pragma once

#include <vector>

#include "geometry/mesh/model_mesh.h"

namespace af2::geometry {

/// Removes vertices that are no corner of an element, and the segments and periodic pairs of
/// vertices with such an end. The others keep their order. For meshes of first order.
void dropUnusedVertices(ModelMesh& mesh);
/// Removes some faces (ids in ascending order) of a mesh on disk, and the vertices on edges that no
/// element uses then.
void dropSpooledFaces(ModelMesh& mesh, const std::vector<int>& faces);

}  // namespace af2::geometry
