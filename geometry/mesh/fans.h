// Adds the ready-made triangles of a face to those that a front has made.
// Not installed.
#pragma once

#include <cstdint>

#include "engine/mesh/mesh.h"
#include "geometry/mesh/face_boundary.h"

namespace af2::geometry {

double areaOfFans(const FaceBoundary& boundary);

/// The tips become the last vertices of the boundary.
///
/// mesh    of the loops of the boundary
/// origin  of the elements of the fans
void addFans(FaceBoundary& boundary, ElementOrigin origin, Mesh& mesh);

}  // namespace af2::geometry
