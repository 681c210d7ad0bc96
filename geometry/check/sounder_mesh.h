// Whether healing was of use, told by the meshes with it and without.
#pragma once

#include "geometry/mesh/model_mesh.h"

namespace af2::geometry {

/// Whether a face was not meshed, or anything else was found at fault.
bool hasFaults(const ModelMesh& mesh);

/// Of the mesh of a healed model and that of the model as it was, the one with fewer faults; the
/// healed one if there are as many. Repairs that are sound by themselves may still leave faces that
/// cannot be meshed. `healing` tells if the model was left as it was.
ModelMesh sounderMesh(ModelMesh healed, ModelMesh asItWas);

}  // namespace af2::geometry
