// Adds ready-made layers of a face to the elements that a front has made on top of them.
// Not installed.
#pragma once

#include "engine/mesh/mesh.h"
#include "geometry/mesh/face_boundary.h"

namespace af2::geometry {

/// The vertices below the tops that are on edges become the last vertices of the boundary.
///
/// mesh    of the loops of the boundary
/// origin  of the elements of the layers
void addLayers(FaceBoundary& boundary, ElementOrigin origin, Mesh& mesh);

}  // namespace af2::geometry
