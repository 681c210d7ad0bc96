// Meshes the faces of a source and checks the mesh, for all kinds of models.
// Not installed.
#pragma once

#include "geometry/meshing/face_source.h"
#include "geometry/meshing/meshing_options.h"

namespace af2::geometry {

/// Meshes the requested faces, each within its edges, which are divided once and shared; retries
/// faces that failed or came out poor; joins the meshes at their edges and keeps what passes the
/// checks. With `elementsAcross`, a first mesh of all faces finds narrow places.
///
/// A face that cannot be meshed is reported as failed and does not affect the others; the same
/// holds for cancelling. Vertices are numbered in this order: at model vertices, along the edges,
/// inside the faces, each group in the order of the model.
///
/// Throws InputError for invalid options, an id that the model does not have, or points that do not
/// divide their edge.
ModelMesh meshFaces(FaceSource& source, const AF2Algorithm& algorithm,
                    const MeshingOptions& options);

}  // namespace af2::geometry
