// Meshes the faces of a CAD model and checks the mesh.
#pragma once

#include "engine/base/export.h"
#include "geometry/mesh/model_mesh.h"
#include "geometry/meshing/meshing_options.h"
#include "geometry/occ/model/model.h"
#include "geometry/occ/sizes/cad_sizes.h"

namespace af2::geometry {

/// Meshes the requested faces, each within its edges, which are divided once and shared.
///
/// A face that cannot be meshed is reported as failed and does not affect the others; the same
/// holds for cancelling. Vertices are numbered in this order: at model vertices, along the edges,
/// inside the faces, each group in the order of the model.
///
/// Each face is checked against its own boundary and surface, and the joined mesh is checked again;
/// faces that do not pass are removed and reported.
///
/// Throws InputError for a size that is not positive, an id that the model does not have, or points
/// that do not divide their edge.
AF2_EXPORT ModelMesh meshModel(const Model& model, const AF2Algorithm& algorithm,
                               const MeshingOptions& options, const TurnLimits& turns = {});

/// An alias for programs written when each kind of model had options of its own.
using ModelMeshingOptions = MeshingOptions;

}  // namespace af2::geometry
