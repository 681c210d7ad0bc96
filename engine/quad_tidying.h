// Takes out what fronts of quadrilaterals leave where they collide: triangles in pairs, vertices
// with too few or too many elements, elements squeezed flat.
#pragma once

#include <vector>

#include "engine/mesh_topology.h"

namespace af2 {

/// Replaces small groups of elements by better ones that fill the same place, as long as that
/// helps. Counts for an element its distortion and whether it is a triangle, for a vertex how far
/// the ideal angles of its elements are from filling the angle there. Only touches quadrilaterals
/// and small islands of triangles among them: where a rule set wants triangles, they stay.
///
/// anglesAtFixed  the angle of the mesh at each fixed vertex, in radians
/// Returns the number of replacements.
std::size_t tidyQuads(MeshTopology& topology, const std::vector<double>& anglesAtFixed);

}  // namespace af2
