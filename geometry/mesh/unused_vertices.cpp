#include "geometry/mesh/unused_vertices.h"

#include <vector>

namespace af2::geometry {

void dropUnusedVertices(ModelMesh& mesh) {
  std::vector<bool> used(mesh.vertices.size(), false);
  for (const Element& element : mesh.elements) {
    for (const VertexId vertex : element.vertices()) used[vertex.value] = true;
  }
  std::vector<VertexId> renumbered(mesh.vertices.size());
  std::size_t count = 0;
  for (std::size_t v = 0; v < used.size(); ++v) {
    if (!used[v]) continue;
    mesh.vertices[count] = mesh.vertices[v];
    if (!mesh.wantedSizes.empty()) mesh.wantedSizes[count] = mesh.wantedSizes[v];
    renumbered[v] = VertexId(count++);
  }
  mesh.vertices.resize(count);
  if (!mesh.wantedSizes.empty()) mesh.wantedSizes.resize(count);
  for (Element& element : mesh.elements) {
    for (VertexId& corner : element.corners) {
      if (!corner.isNone()) corner = renumbered[corner.value];
    }
  }
  std::erase_if(mesh.segments,
                [&](const EdgeSegment& s) { return !used[s.from.value] || !used[s.to.value]; });
  for (EdgeSegment& segment : mesh.segments) {
    segment.from = renumbered[segment.from.value];
    segment.to = renumbered[segment.to.value];
  }
  for (PeriodicPair& pair : mesh.periodic) {
    std::erase_if(pair.vertices,
                  [&](const auto& v) { return !used[v.first.value] || !used[v.second.value]; });
    for (auto& [second, first] : pair.vertices) {
      second = renumbered[second.value];
      first = renumbered[first.value];
    }
  }
}

}  // namespace af2::geometry
