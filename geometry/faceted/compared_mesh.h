// Compares a mesh with the triangles that it was made on.
// Not installed.
#pragma once

#include "geometry/faceted/facets.h"
#include "geometry/mesh/model_mesh.h"

namespace af2::geometry {

/// Adds a finding if the mesh has free edges but the triangles are closed, and a note if it
/// encloses another volume than they do. Nothing if a face failed or was left out.
void compareWithTriangles(const Facets& facets, ModelMesh& mesh);

}  // namespace af2::geometry
