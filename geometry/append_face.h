// One face joins the mesh of its model.
#pragma once

#include <vector>

#include "engine/algorithm.h"
#include "geometry/model_mesh.h"

namespace af2::geometry {

/// Adds the vertices inside the face and its elements, and counts them in `report`.
///   boundary   the vertices of `mesh` that the first vertices of `result` stand for
void appendFace(ModelMesh& mesh, const MeshingResult& result, const std::vector<VertexId>& boundary,
                FaceReport& report);

}  // namespace af2::geometry
