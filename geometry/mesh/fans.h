// Adds the ready-made elements of a face to those that a front has made.
// Not installed.
#pragma once

#include <cstdint>

#include "engine/mesh/mesh.h"
#include "geometry/mesh/face_boundary.h"

namespace af2::geometry {

double areaOfFans(const FaceBoundary& boundary);

/// `Quads`: triangles are joined in pairs where this gives sound quadrilaterals.
enum class FanElements { Triangles, Quads };

/// The tips become the last vertices of the boundary.
///
/// mesh    of the loops of the boundary
/// origin  of the elements of the fans
void addFans(FaceBoundary& boundary, FanElements kind, ElementOrigin origin, Mesh& mesh);

/// The boundary of a mesh to which addFans has added the fans: around these, and not along their
/// rims.
MeshBoundary boundaryWithFans(const FaceBoundary& boundary);

}  // namespace af2::geometry
