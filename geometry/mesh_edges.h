// The edges of a mesh, each once.
#pragma once

#include <vector>

#include "geometry/model_mesh.h"

namespace af2::geometry {

struct MeshEdge {
  VertexId from, to;  ///< from < to
  /// The first and the last of the model faces, in the order of the elements, that use the edge.
  int firstFace = 0, lastFace = 0;
  int modelEdge = 0;  ///< the model edge that it is a piece of; 0: none
  int uses = 0;       ///< how many elements have it
  bool operator==(const MeshEdge&) const = default;
};

/// Sorted by (from, to). Takes time linear in the number of elements.
std::vector<MeshEdge> meshEdges(const ModelMesh& mesh);

}  // namespace af2::geometry
