// From a source of faces to a checked mesh: the one mesher of all kinds of models.
// Not installed.
#pragma once

#include "geometry/meshing/face_source.h"
#include "geometry/meshing/meshing_options.h"

namespace af2::geometry {

/// Meshes the faces asked for, each within its edges, which are divided once and shared; tries
/// again where faces failed or came out poor; joins the meshes at their edges and keeps what passes
/// the checks. With `elementsAcross`, a first mesh of all faces shows what is narrow.
///
/// A face that cannot be meshed is reported as failed and does not spoil the others; so does
/// cancelling. Vertices are numbered: those of model vertices, those along the edges, those inside
/// the faces, each in the order of the model.
///
/// Throws InputError for options that make no sense, an id that the model does not have, or points
/// that do not divide their edge.
ModelMesh meshFaces(FaceSource& source, const AF2Algorithm& algorithm,
                    const MeshingOptions& options);

}  // namespace af2::geometry
