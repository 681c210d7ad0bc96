// Splits sharp seams: where a surface meets itself at an angle, its seam is an edge.
// Not installed.
#pragma once

#include <cstdint>
#include <vector>

#include "engine/mesh/front_input.h"

namespace af2::geometry {

/// Where the normals at the corners of one vertex differ by more than a smooth surface bends, as on
/// the two sides of a seam at the sharp trailing edge of a wing, gives each side a vertex of its
/// own. This is needed because a vertex of the mesh has one normal, and no element may face away
/// from it.
///
/// points  the point of each vertex; extended by those of the new vertices
void partSharpSeams(FrontInput& input, std::vector<std::uint32_t>& points);

/// Gives each side of every seam vertices of its own, one for each place in the parameters.
void partSeams(FrontInput& input, std::vector<std::uint32_t>& points);

}  // namespace af2::geometry
