// Removes what the elements of a mesh do not use.
// Not installed.
#pragma once

#include "geometry/mesh/model_mesh.h"

namespace af2::geometry {

/// Removes vertices that are no corner of an element, and the segments and periodic pairs of
/// vertices with such an end. The others keep their order. For meshes of first order.
void dropUnusedVertices(ModelMesh& mesh);

}  // namespace af2::geometry
