// Requests for layers that came to nothing. Not installed.
#pragma once

#include <vector>

#include "geometry/layers/layer_request.h"
#include "geometry/mesh/model_mesh.h"

namespace af2::geometry {

/// Adds a finding for each request of which the mesh has not a single layer.
void tellOfMissingLayers(const std::vector<LayerRequest>& requests, ModelMesh& mesh);

}  // namespace af2::geometry
