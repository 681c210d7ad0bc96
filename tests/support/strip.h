// A mesh of squares in a row.
#pragma once

#include <vector>

#include "geometry/mesh/model_mesh.h"

namespace af2::testing {

/// Those squares that are divided are two triangles, the others quadrilaterals. Each face has so
/// many squares.
inline geometry::ModelMesh strip(const std::vector<bool>& areDivided, std::size_t squaresOfFace) {
  geometry::ModelMesh mesh;
  for (std::size_t i = 0; i <= areDivided.size(); ++i)
    for (const double y : {0.0, 1.0}) mesh.vertices.push_back({static_cast<double>(i), y, 0});
  for (std::size_t i = 0; i < areDivided.size(); ++i) {
    const VertexId a(2 * i), b(2 * i + 2), c(2 * i + 3), d(2 * i + 1);
    if (areDivided[i]) {
      mesh.elements.push_back({{a, b, c, VertexId()}});
      mesh.elements.push_back({{a, c, d, VertexId()}});
    } else {
      mesh.elements.push_back({{a, b, c, d}});
    }
    mesh.face.resize(mesh.elements.size(), static_cast<std::int32_t>(1 + i / squaresOfFace));
  }
  return mesh;
}

/// Of triangles.
inline geometry::ModelMesh strip(std::size_t squares, std::size_t squaresOfFace = 1000) {
  return strip(std::vector<bool>(squares, true), squaresOfFace);
}

/// Names the faces, and adds segments around each of them.
inline void outlineFaces(geometry::ModelMesh& mesh, std::size_t squaresOfFace) {
  const std::size_t squares = mesh.vertices.size() / 2 - 1;
  for (std::size_t i = 0; i < squares; ++i) {
    if (i % squaresOfFace == 0)
      mesh.faces.emplace_back().id = static_cast<int>(1 + i / squaresOfFace);
    for (const std::size_t y : {0u, 1u})
      mesh.segments.push_back({VertexId(2 * i + y), VertexId(2 * i + 2 + y), 1, 1, {}});
    if (i > 0 && i % squaresOfFace == 0)
      mesh.segments.push_back({VertexId(2 * i), VertexId(2 * i + 1), 1, 2, {}});
  }
}

}  // namespace af2::testing
