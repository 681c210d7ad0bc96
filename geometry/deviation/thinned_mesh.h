// Removes the vertices of a mesh that a bound on the distance from the model does not need.
// Not installed.
#pragma once

#include "geometry/deviation/measured_mesh.h"

namespace af2::geometry {

struct ThinningLimits {
  double longest = 0;                     ///< side of a new triangle
  std::vector<std::uint8_t> isKept = {};  ///< by vertex: it stays; empty: none has to
};

/// Moves vertices onto neighbours, one after the other, as long as the new triangles and segments
/// keep the bounds of the task, look to the same side as those before, and are no needles. Vertices
/// inside faces and along edges go; the ends of edges, and vertices of quadrilaterals, stay.
/// Segments and elements keep their order, and vertices theirs.
///
/// curves  of the segments of the mesh, which change with them
///
/// Returns how many vertices were removed.
std::size_t thin(ModelMesh& mesh, EdgeCurves& curves, const DeviationTask& task,
                 const ThinningLimits& limits);

}  // namespace af2::geometry
