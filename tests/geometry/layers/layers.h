// What tests ask of meshes with layers.
#pragma once

#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

#include "geometry/layers/layer_request.h"
#include "tests/support/model_mesh.h"

namespace af2::testing {

inline geometry::LayerRequest layersAlong(std::vector<int> edges, double first, double growth,
                                          int count) {
  geometry::LayerRequest request;
  request.edges = std::move(edges);
  request.first = first;
  request.growth = growth;
  request.count = count;
  return request;
}

/// Distances of the tops of layers from their edge; [0] is 0.
inline std::vector<double> topsOf(const geometry::LayerRequest& request) {
  std::vector<double> tops{0};
  double height = request.first;
  for (int layer = 0; layer < request.count; ++layer, height *= request.growth)
    tops.push_back(tops.back() + height);
  return tops;
}

inline bool isOfLayer(const geometry::ModelMesh& mesh, std::size_t element) {
  return mesh.ruleNames.at(mesh.origins[element].rule) == "layer";
}

/// The vertices of the elements of layers.
inline std::set<VertexId> layerVertices(const geometry::ModelMesh& mesh) {
  std::set<VertexId> vertices;
  for (std::size_t e = 0; e < mesh.elements.size(); ++e)
    if (isOfLayer(mesh, e))
      for (const VertexId v : mesh.elements[e].vertices()) vertices.insert(v);
  return vertices;
}

/// Whether a distance is that of the top of a layer, or zero.
inline bool isTop(double distance, const std::vector<double>& tops, double tolerance) {
  return std::ranges::any_of(tops,
                             [&](double top) { return std::abs(distance - top) <= tolerance; });
}

/// Elements of a mesh in the plane z = 0 that are not convex and counter-clockwise.
inline std::size_t invertedIn(const geometry::ModelMesh& mesh) {
  std::size_t inverted = 0;
  for (const Element& element : mesh.elements) {
    const auto corners = element.vertices();
    const auto at = [&](std::size_t i) { return mesh.vertices[corners[i % corners.size()].value]; };
    for (std::size_t i = 0; i < corners.size(); ++i)
      if (!(cross(at(i + 1) - at(i), at(i + 2) - at(i + 1)).z > 0)) ++inverted;
  }
  return inverted;
}

/// Of triangles and quadrilaterals.
inline double areaWithQuads(const geometry::ModelMesh& mesh) {
  double area = 0;
  for (const Element& element : mesh.elements) {
    const auto at = [&](std::size_t i) { return mesh.vertices[element.corners[i].value]; };
    area += length(cross(at(1) - at(0), at(2) - at(0))) / 2;
    if (element.isQuad()) area += length(cross(at(2) - at(0), at(3) - at(0))) / 2;
  }
  return area;
}

inline std::size_t layerElements(const geometry::ModelMesh& mesh) {
  std::size_t count = 0;
  for (const geometry::FaceReport& face : mesh.faces) count += face.layerElements;
  return count;
}

inline std::size_t layerTriangles(const geometry::ModelMesh& mesh) {
  std::size_t count = 0;
  for (std::size_t e = 0; e < mesh.elements.size(); ++e)
    if (isOfLayer(mesh, e) && !mesh.elements[e].isQuad()) ++count;
  return count;
}

/// Segments above which there are fewer layers than asked.
inline std::size_t segmentsWithFewer(const geometry::ModelMesh& mesh) {
  std::size_t count = 0;
  for (const geometry::FaceReport& face : mesh.faces)
    for (const geometry::LayersAlongEdge& along : face.layers) count += along.fewer;
  return count;
}

}  // namespace af2::testing
