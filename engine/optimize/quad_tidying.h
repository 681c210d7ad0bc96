// Takes out what fronts of quadrilaterals leave where they collide: triangles in pairs, vertices
// with too few or too many elements, elements squeezed flat.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "engine/mesh/mesh_topology.h"

namespace af2 {

/// Replaces small groups of elements by better ones that fill the same place, as long as that
/// helps. Counts for an element its distortion and whether it is a triangle, for a vertex how far
/// the ideal angles of its elements are from filling the angle there. Only touches quadrilaterals,
/// triangles that closed a front, and small islands of others: where a rule set wants triangles,
/// they stay.
///
/// anglesAtFixed  the angle of the mesh at each fixed vertex, in radians
/// closingRule    made the triangles that closed a front; see OptimizeOptions
/// Returns the number of replacements.
std::size_t tidyQuads(MeshTopology& topology, const std::vector<double>& anglesAtFixed,
                      std::optional<std::uint16_t> closingRule);

}  // namespace af2
