// Which layers each face gets. Not installed.
#pragma once

#include <span>

#include "geometry/layers/layer_heights.h"
#include "geometry/layers/layer_request.h"

namespace af2::geometry {

/// The layers of a face by id of its edges. Later requests replace earlier ones.
///
/// requests  without names
/// edges     of the face, ascending
EdgeLayers layersOfFace(std::span<const LayerRequest> requests, int face,
                        const std::vector<int>& edges);

}  // namespace af2::geometry
