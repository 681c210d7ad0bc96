#include "geometry/quality/boundary_distance.h"

namespace af2::geometry {

VertexNeighbors::VertexNeighbors(const ModelMesh& mesh) : first_(mesh.vertices.size() + 1, 0) {
  const MeshSides sides(mesh);
  const auto forEachEnd = [&](const auto& visit) {
    sides.forEachEdge([&](VertexId from, std::span<const MeshSide> of) {
      visit(from.value, of.front().to);
      visit(of.front().to, from.value);
    });
  };
  forEachEnd([&](std::uint32_t from, std::uint32_t) { ++first_[from + 1]; });
  for (std::size_t v = 1; v < first_.size(); ++v) first_[v] += first_[v - 1];
  neighbors_.resize(first_.back());
  std::vector<std::size_t> next(first_.begin(), first_.end() - 1);
  forEachEnd([&](std::uint32_t from, std::uint32_t to) { neighbors_[next[from]++] = to; });
}

std::vector<std::uint32_t> edgesToBoundary(const VertexNeighbors& neighbors, const MeshFans& fans) {
  std::vector<std::uint32_t> distance(neighbors.vertexCount(), kNoBoundary), reached;
  const auto reach = [&](std::uint32_t vertex, std::uint32_t edges) {
    if (distance[vertex] <= edges) return;
    distance[vertex] = edges;
    reached.push_back(vertex);
  };
  for (const auto& [from, to] : fans.boundaryEdges()) {
    reach(from.value, 0);
    reach(to.value, 0);
  }
  for (std::size_t i = 0; i < reached.size(); ++i)
    for (const std::uint32_t neighbor : neighbors.of(reached[i]))
      reach(neighbor, distance[reached[i]] + 1);
  return distance;
}

}  // namespace af2::geometry
