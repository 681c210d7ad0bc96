// Small meshes to be measured.
#pragma once

#include "tests/support/small_meshes.h"

namespace af2::geometry {

/// An empty mesh with these vertices.
inline ModelMesh withVertices(std::vector<Point3> vertices) {
  ModelMesh mesh;
  mesh.vertices = std::move(vertices);
  return mesh;
}

/// Adds elements of a face: their corners, three or four.
inline void addElements(ModelMesh& mesh, const std::vector<std::vector<std::size_t>>& elements,
                        int face = 1) {
  for (const auto& corners : elements) {
    Element element{};
    for (std::size_t i = 0; i < corners.size(); ++i) element.corners[i] = VertexId(corners[i]);
    mesh.elements.push_back(element);
    mesh.face.push_back(face);
    mesh.origins.emplace_back();
  }
}

/// The square [0, n]^2 in unit squares, on face 1.
inline ModelMesh squareGrid(std::size_t n) {
  ModelMesh mesh;
  for (std::size_t j = 0; j <= n; ++j)
    for (std::size_t i = 0; i <= n; ++i)
      mesh.vertices.push_back({static_cast<double>(i), static_cast<double>(j), 0});
  for (std::size_t j = 0; j < n; ++j)
    for (std::size_t i = 0; i < n; ++i) {
      const std::size_t v = j * (n + 1) + i;
      addElements(mesh, {{v, v + 1, v + n + 2, v + n + 1}});
    }
  return mesh;
}

/// The cube [0, 1]^3 in six squares, all on face 1 or each on a face of its own.
inline ModelMesh squareCube(bool hasFaces) {
  ModelMesh mesh = withVertices(
      {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}});
  const std::vector<std::vector<std::size_t>> sides{{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4},
                                                    {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}};
  for (std::size_t i = 0; i < sides.size(); ++i)
    addElements(mesh, {sides[i]}, hasFaces ? static_cast<int>(i) + 1 : 1);
  return mesh;
}

}  // namespace af2::geometry
