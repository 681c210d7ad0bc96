// The edges of a mesh, each once.
#pragma once

#include <algorithm>
#include <vector>

#include "geometry/mesh/mesh_sides.h"
#include "geometry/mesh/model_mesh.h"

namespace af2::testing {

struct MeshEdge {
  VertexId from, to;  ///< from < to
  /// The first and the last of the model faces, in the order of the elements, that use the edge.
  int firstFace = 0, lastFace = 0;
  int modelEdge = 0;  ///< the model edge that it is a piece of; 0: none
};

/// Sorted by (from, to).
inline std::vector<MeshEdge> meshEdges(const geometry::ModelMesh& mesh) {
  std::vector<MeshEdge> edges;
  geometry::MeshSides(mesh).forEachEdge(
      [&](VertexId from, std::span<const geometry::MeshSide> used) {
        edges.push_back({from, VertexId(used.front().to), mesh.face[used.front().element()],
                         mesh.face[used.back().element()]});
      });
  for (const geometry::EdgeSegment& segment : mesh.segments) {
    const auto [from, to] = std::minmax(segment.from, segment.to);
    const auto edge = std::ranges::lower_bound(
        edges, std::pair(from, to), {}, [](const MeshEdge& e) { return std::pair(e.from, e.to); });
    if (edge != edges.end() && edge->from == from && edge->to == to) edge->modelEdge = segment.edge;
  }
  return edges;
}

}  // namespace af2::testing
