#include "geometry/mesh/layer_elements.h"

namespace af2::geometry {

void addLayers(FaceBoundary& boundary, ElementOrigin origin, Mesh& mesh) {
  if (!boundary.layers || boundary.layers->elements.empty()) return;
  const FaceBoundary::Layers& layers = *boundary.layers;
  // The ids of the boundary, then new ones of it, then those of the front, then new ones inside.
  const std::size_t edges = boundary.points.size(), added = layers.points.size();
  const std::size_t front = boundary.input.vertexCount;
  const std::size_t all = mesh.vertices.size() + added;
  const auto moved = [&](VertexId v) { return v.value < edges ? v : VertexId(v.value + added); };
  const auto placed = [&](VertexId v) {
    if (v.value < front) return moved(v);
    return v.value < front + added ? VertexId(v.value - front + edges)
                                   : VertexId(v.value - front - added + all);
  };
  for (Element& element : mesh.elements)
    for (VertexId& v : element.corners)
      if (!v.isNone()) v = moved(v);
  for (FaceBoundary::Fan& fan : boundary.fans)
    for (VertexId& v : fan.rim) v = moved(v);
  mesh.vertices.insert(mesh.vertices.begin() + static_cast<std::ptrdiff_t>(edges),
                       layers.places.begin(), layers.places.end());
  mesh.vertices.insert(mesh.vertices.end(), layers.inside.begin(), layers.inside.end());
  boundary.points.insert(boundary.points.end(), layers.points.begin(), layers.points.end());
  for (Element element : layers.elements) {
    for (VertexId& v : element.corners)
      if (!v.isNone()) v = placed(v);
    mesh.elements.push_back(element);
    mesh.origins.push_back(origin);
  }
}

}  // namespace af2::geometry
