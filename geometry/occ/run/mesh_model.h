// From a CAD model to a checked mesh of its faces.
#pragma once

#include "engine/base/export.h"
#include "geometry/mesh/model_mesh.h"
#include "geometry/meshing/meshing_options.h"
#include "geometry/occ/model/model.h"
#include "geometry/occ/sizes/cad_sizes.h"

namespace af2::geometry {

/// Meshes the faces asked for, each within its edges, which are divided once and shared.
///
/// A face that cannot be meshed is reported as failed and does not spoil the others; so does
/// cancelling. Vertices are numbered: those of model vertices, those along the edges, those inside
/// the faces, each in the order of the model.
///
/// Each face is held against its own boundary and surface, and the joined mesh once more: what does
/// not pass is taken out and reported.
///
/// Throws InputError for a size that is not positive, an id that the model does not have, or points
/// that do not divide their edge.
AF2_EXPORT ModelMesh meshModel(const Model& model, const AF2Algorithm& algorithm,
                               const MeshingOptions& options, const TurnLimits& turns = {});

/// As programs may call it that were written when each kind of model had options of its own.
using ModelMeshingOptions = MeshingOptions;

}  // namespace af2::geometry
