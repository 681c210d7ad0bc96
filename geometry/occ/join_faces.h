// Joins the meshes of faces at the vertices of their edges.
// Not installed: includers need OpenCASCADE's headers.
#pragma once

#include "geometry/occ/face_mesher.h"

namespace af2::geometry {

/// Vertices are numbered: those of model vertices, those along edges, those inside faces. Vertices
/// that no element uses are left out.
ModelMesh joinFaces(const ModelShape& model, const DividedEdges& divided,
                    const ModelMeshingOptions& options, const std::vector<FaceMesh>& faces);

}  // namespace af2::geometry
