// The ready-made triangles of a face, put to those that a front has made.
// Not installed.
#pragma once

#include <cstdint>

#include "engine/mesh/mesh.h"
#include "geometry/mesh/face_boundary.h"

namespace af2::geometry {

double areaOfFans(const FaceBoundary& boundary);

/// The tips become the last vertices of the boundary.
///
/// mesh  of the loops of the boundary
/// rule  by which its elements count as made
void addFans(FaceBoundary& boundary, std::uint16_t rule, Mesh& mesh);

}  // namespace af2::geometry
