// Removes defects where fronts of quadrilaterals collide: pairs of triangles, vertices with too few
// or too many elements, flat elements.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "engine/base/work_watch.h"
#include "engine/mesh/mesh_topology.h"
#include "engine/optimize/act_recorder.h"

namespace af2 {

/// Whether poor elements of a mesh of sound quadrilaterals alone may become triangles.
enum class MayAddTriangles : std::uint8_t { No, Yes };

/// Replaces small groups of elements by better ones with the same outline, as long as that lowers
/// the total cost (see QuadChanges). Only changes quadrilaterals, triangles that closed a front,
/// and small groups of other triangles: where a rule set makes triangles on purpose, they stay.
/// Ends early if a stop is requested.
///
/// anglesAtFixed  the angle that the mesh has at each fixed vertex, in radians
/// closingRule    the rule that made the triangles that closed a front; see OptimizeOptions
/// Returns the number of replacements.
std::size_t tidyQuads(MeshTopology& topology, const std::vector<double>& anglesAtFixed,
                      std::optional<std::uint16_t> closingRule, ActRecorder* recorder = nullptr,
                      MayAddTriangles triangles = MayAddTriangles::Yes,
                      const WorkWatch& watch = {});

}  // namespace af2
