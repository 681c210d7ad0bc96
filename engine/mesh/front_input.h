// The boundary of a region to be meshed, a self-contained value.
#pragma once

#include <algorithm>
#include <utility>
#include <vector>

#include "engine/base/ids.h"
#include "engine/base/point.h"

namespace af2 {

/// One corner of a boundary loop. A vertex may be a corner several times, at the ends of a seam or
/// where loops touch. Its parameters (u, v) then differ from corner to corner; its position does
/// not.
struct BoundaryCorner {
  VertexId vertex;
  SurfacePoint point;
};

/// Closed directed loops with the region to be meshed on their left, seen from the side to which
/// the normals point. Holes run in the opposite direction to outer loops. A line inside the region
/// that the mesh must keep appears in both directions.
struct FrontInput {
  std::vector<std::vector<BoundaryCorner>> loops;
  std::vector<BoundaryCorner> isolated;  ///< vertices inside the region that the mesh must use
  std::size_t vertexCount = 0;           ///< vertex ids of all corners are below this
};

/// The part of the boundary that a mesh must keep.
struct MeshBoundary {
  std::size_t fixedCount = 0;  ///< vertices with lower ids do not move
  /// Directed edges with an element on their left, sorted; a line inside appears in both
  /// directions.
  std::vector<std::pair<VertexId, VertexId>> edges;

  bool contains(VertexId from, VertexId to) const {
    return from.value < fixedCount && to.value < fixedCount &&
           std::binary_search(edges.begin(), edges.end(), std::pair(from, to));
  }
};

inline MeshBoundary boundaryOf(const FrontInput& input) {
  MeshBoundary boundary{input.vertexCount, {}};
  for (const auto& loop : input.loops)
    for (std::size_t i = 0; i < loop.size(); ++i)
      boundary.edges.emplace_back(loop[i].vertex, loop[(i + 1) % loop.size()].vertex);
  std::sort(boundary.edges.begin(), boundary.edges.end());
  return boundary;
}

}  // namespace af2
