// How many edges vertices are away from the nearest boundary.
// Not installed.
#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "geometry/quality/mesh_fans.h"

namespace af2::geometry {

/// The vertices that edges join to each vertex.
class VertexNeighbors {
 public:
  explicit VertexNeighbors(const ModelMesh& mesh);
  std::span<const std::uint32_t> of(std::size_t vertex) const {
    return {neighbors_.data() + first_[vertex], first_[vertex + 1] - first_[vertex]};
  }
  std::size_t vertexCount() const { return first_.size() - 1; }

 private:
  std::vector<std::size_t> first_;  // by vertex, and the end of the last
  std::vector<std::uint32_t> neighbors_;
};

/// Of vertices that no path joins to a boundary.
inline constexpr std::uint32_t kNoBoundary = std::numeric_limits<std::uint32_t>::max();

/// By vertex.
std::vector<std::uint32_t> edgesToBoundary(const VertexNeighbors& neighbors, const MeshFans& fans);

}  // namespace af2::geometry
