// Swaps sides between two triangles where that gives better triangles or more regular vertices.
#pragma once

#include <cstdint>
#include <vector>

#include "engine/base/work_watch.h"
#include "engine/mesh/mesh_topology.h"
#include "engine/optimize/act_recorder.h"

namespace af2 {

/// The quantity that a swap must improve.
enum class SwapGoal {
  Valence,  ///< the deviation from 6 triangles at each vertex, as long as shapes stay fair
  Shape,    ///< the worse of the two triangles
};

/// The ideal number of triangles at vertices with these angles.
std::vector<std::uint8_t> wantedValences(const std::vector<double>& angles);

/// Sweeps over all sides in order; for the Valence goal twice, with the most useful swaps first.
/// Ends early if a stop is requested. Returns the number of swapped sides.
std::size_t swapSides(MeshTopology& topology, SwapGoal goal,
                      const std::vector<std::uint8_t>& wantedAtFixed,
                      ActRecorder* recorder = nullptr, const WorkWatch& watch = {});

}  // namespace af2
