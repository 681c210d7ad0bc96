// The vertices of elements and lines in the order of most formats.
// Not installed.
#pragma once

#include <vector>

#include "geometry/io/line_elements.h"
#include "geometry/mesh/model_mesh.h"

namespace af2::geometry {

/// Corners, then middles of sides.
template <class Visit>
void forEachMshVertex(const ModelMesh& mesh, const MeshSlice& slice, std::size_t i,
                      const Visit& visit) {
  const auto corners = slice.elements[i].vertices();
  for (const VertexId corner : corners) visit(corner);
  for (std::size_t k = 0; !mesh.midsides.empty() && k < corners.size(); ++k)
    visit(mesh.midsides[slice.firstElement + i][k]);
}
/// The same as a list, of a mesh in memory.
inline std::vector<VertexId> mshVertices(const ModelMesh& mesh, std::size_t element) {
  const auto corners = mesh.elements[element].vertices();
  std::vector<VertexId> vertices(corners.begin(), corners.end());
  for (std::size_t i = 0; !mesh.midsides.empty() && i < corners.size(); ++i)
    vertices.push_back(mesh.midsides[element][i]);
  return vertices;
}

/// Ends, then the middle.
inline std::vector<VertexId> mshVertices(const LineElement& line) {
  std::vector<VertexId> vertices{line.from, line.to};
  if (!line.middle.isNone()) vertices.push_back(line.middle);
  return vertices;
}

}  // namespace af2::geometry
