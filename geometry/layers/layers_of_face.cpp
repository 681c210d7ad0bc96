#include "geometry/layers/layers_of_face.h"

#include <algorithm>

namespace af2::geometry {

EdgeLayers layersOfFace(std::span<const LayerRequest> requests, int face,
                        const std::vector<int>& edges) {
  EdgeLayers layers;
  for (const LayerRequest& request : requests) {
    if (!request.faces.empty() && std::ranges::count(request.faces, face) == 0) continue;
    for (const int edge : request.edges)
      if (std::ranges::binary_search(edges, edge))
        layers[edge] = {request.first, request.growth, request.count};
  }
  return layers;
}

}  // namespace af2::geometry
