#include "geometry/layers/missing_layers.h"

#include <algorithm>
#include <string>

#include "engine/base/place_text.h"

namespace af2::geometry {

void tellOfMissingLayers(const std::vector<LayerRequest>& requests, ModelMesh& mesh) {
  for (const LayerRequest& request : requests) {
    std::size_t edges = 0, most = 0;
    for (const FaceReport& face : mesh.faces)
      for (const LayersAlongEdge& along : face.layers) {
        if (std::ranges::count(request.edges, along.edge) == 0) continue;
        ++edges;
        most = std::max(most, along.most);
      }
    if (edges > 0 && most == 0)
      mesh.findings.push_back(
          "there are no layers along edge " + std::to_string(request.edges.front()) +
          (request.edges.size() > 1 ? " and the others of its request" : "") +
          ": a first layer of height " + af2::textOf(request.first, 4) + " has no room there");
  }
}

}  // namespace af2::geometry
