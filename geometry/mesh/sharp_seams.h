// A surface may come back to itself at an angle: then its seam is an edge, not a place like others.
// Not installed.
#pragma once

#include <cstdint>
#include <vector>

#include "engine/mesh/front_input.h"

namespace af2::geometry {

/// Where the normals at the corners of one vertex differ by more than a surface bends, as on the
/// two sides of a seam at the sharp trailing edge of a wing, gives each side a vertex of its own.
/// The mesh knows each vertex with one normal, and no element may turn away from it.
///
/// points  by vertex: which point it is; gets those of the new vertices
void partSharpSeams(FrontInput& input, std::vector<std::uint32_t>& points);

/// Gives each side of every seam vertices of its own: each place in the parameters.
void partSeams(FrontInput& input, std::vector<std::uint32_t>& points);

}  // namespace af2::geometry
