// Which diagonal divides a quadrilateral where triangles are needed: the one at its first corner.
// Not installed.
#pragma once

#include "engine/mesh/front_input.h"
#include "engine/mesh/mesh.h"

namespace af2::geometry {

/// Quadrilaterals with two adjacent sides on the boundary begin at the corner between these. With
/// the other diagonal, quadrilaterals of two faces at the same corner of the boundary would have a
/// triangle in common, as if one face lay on the other.
void beginAtBoundaryCorners(const MeshBoundary& boundary, Mesh& mesh);

}  // namespace af2::geometry
