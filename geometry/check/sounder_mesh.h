// Chooses between the meshes of a model with healing and without.
#pragma once

#include "engine/base/export.h"
#include "geometry/mesh/model_mesh.h"

namespace af2::geometry {

/// Whether a face was not meshed, or any other fault was found.
AF2_EXPORT bool hasFaults(const ModelMesh& mesh);

/// Of the meshes of a healed model and of the original model, returns the one with fewer faults;
/// the healed one if they have equally many. Repairs that are valid by themselves may still leave
/// faces that cannot be meshed. `healing` of the result says if the original model was kept.
AF2_EXPORT ModelMesh sounderMesh(ModelMesh healed, ModelMesh asItWas);

}  // namespace af2::geometry
