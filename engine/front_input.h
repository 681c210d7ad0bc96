// The boundary of a region to be meshed, a self-contained value.
#pragma once

#include <vector>

#include "engine/ids.h"
#include "engine/point.h"

namespace af2 {

/// One corner of a boundary loop. A vertex may be a corner several times: at the ends of a seam, or
/// where loops touch; its parameters (u, v) then differ from corner to corner, its position does
/// not.
struct BoundaryCorner {
  VertexId vertex;
  SurfacePoint point;
};

/// Closed directed loops with the region to be meshed on their left, seen from the side to which
/// the normals point. Holes run the other way round than outer loops. A line inside the region that
/// the mesh must keep appears in both directions.
struct FrontInput {
  std::vector<std::vector<BoundaryCorner>> loops;
  std::vector<BoundaryCorner> isolated;  ///< vertices inside the region that the mesh must use
  std::size_t vertexCount = 0;           ///< corners' vertex ids lie below this
};

}  // namespace af2
