// Turns sides between two triangles where that makes better triangles or more regular vertices.
#pragma once

#include <cstdint>
#include <vector>

#include "engine/mesh/mesh_topology.h"

namespace af2 {

/// What a swap must improve.
enum class SwapGoal {
  Valence,  ///< the deviation from 6 triangles at each vertex, as long as shapes stay fair
  Shape,    ///< the worse of the two triangles
};

/// Number of triangles that vertices with such angles should have.
std::vector<std::uint8_t> wantedValences(const std::vector<double>& angles);

/// Sweeps over all sides in order; for the sake of valence twice, the swaps that help most first.
/// Returns how many were turned.
std::size_t swapSides(MeshTopology& topology, SwapGoal goal,
                      const std::vector<std::uint8_t>& wantedAtFixed);

}  // namespace af2
