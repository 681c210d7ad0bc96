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
  sides.forEachEdge([&](VertexId from, std::span<const MeshSide> used) {
    edges.push_back({from, VertexId(used.front().to), mesh.face[used.front().element()],
                     mesh.face[used.back().element()], 0, static_cast<int>(used.size())});
  });
  markModelEdges(mesh, edges);
  return edges;
}

}  // namespace af2::geometry
