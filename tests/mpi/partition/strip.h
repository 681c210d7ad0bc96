// A mesh for tests of its parts.
#pragma once

#include <algorithm>

#include "geometry/mesh/model_mesh.h"

namespace af2::testing {

/// A strip of squares, of which each is cut in two triangles. Each face has so many squares.
inline geometry::ModelMesh strip(std::size_t squares, std::size_t squaresOfFace = 1000) {
  geometry::ModelMesh mesh;
  for (std::size_t i = 0; i <= squares; ++i)
    for (const double y : {0.0, 1.0}) mesh.vertices.push_back({static_cast<double>(i), y, 0});
  for (std::size_t i = 0; i < squares; ++i) {
    const VertexId a(2 * i), b(2 * i + 2), c(2 * i + 3), d(2 * i + 1);
    mesh.elements.push_back({{a, b, c, VertexId()}});
    mesh.elements.push_back({{a, c, d, VertexId()}});
    mesh.face.insert(mesh.face.end(), 2, static_cast<std::int32_t>(1 + i / squaresOfFace));
  }
  return mesh;
}

}  // namespace af2::testing
