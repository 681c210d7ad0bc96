// Line elements along the edges of a model, for conditions that hold at boundaries.
#pragma once

#include <vector>

#include "engine/base/export.h"
#include "geometry/mesh/model_mesh.h"

namespace af2::geometry {

/// Which edges of the model get line elements in formats that support them.
enum class LinesAlong {
  Boundaries,  ///< those that the file of the model marks
  AllEdges,
};

struct LineElement {
  VertexId from, to;
  VertexId middle;   ///< only if of second order
  int edge = 0;      ///< id of the model edge
  int boundary = 0;  ///< its number; 0: the edge is in none
};

/// In the order of the edges and along them. Each is a side of some element of the mesh.
AF2_EXPORT std::vector<LineElement> lineElements(const ModelMesh& mesh, LinesAlong along);

}  // namespace af2::geometry
