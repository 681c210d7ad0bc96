#include "geometry/mesh_edges.h"

#include <algorithm>

#include "geometry/mesh_sides.h"

namespace af2::geometry {
namespace {

void markModelEdges(const ModelMesh& mesh, std::vector<MeshEdge>& edges) {
  for (const EdgeSegment& segment : mesh.segments) {
    const auto [from, to] = std::minmax(segment.from, segment.to);
    const auto edge = std::ranges::lower_bound(
        edges, std::pair(from, to), {}, [](const MeshEdge& e) { return std::pair(e.from, e.to); });
    if (edge != edges.end() && edge->from == from && edge->to == to) edge->modelEdge = segment.edge;
  }
}

}  // namespace

std::vector<MeshEdge> meshEdges(const ModelMesh& mesh) {
  const MeshSides sides(mesh);
  std::vector<MeshEdge> edges;
  edges.reserve(sides.count() / 2 + mesh.segments.size());
  for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
    std::uint32_t last = VertexId::kNone;
    for (const MeshSide& side : sides.of(v)) {
      const int face = mesh.face[side.element()];
      if (side.to != last) edges.push_back({VertexId(v), VertexId(side.to), face, face, 0, 0});
      last = side.to;
      edges.back().lastFace = face;
      ++edges.back().uses;
    }
  }
  markModelEdges(mesh, edges);
  return edges;
}

}  // namespace af2::geometry
