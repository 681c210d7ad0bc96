// Edges that follow each other smoothly, divided as one.
// Not installed: includers need OpenCASCADE's headers.
#pragma once

#include <vector>

#include "geometry/occ/edges/edge_chains.h"
#include "geometry/occ/merge/face_grouping.h"

namespace af2::geometry {

/// Chains of kept edges. A vertex inside a chain has no other kept edges, and an edge that the mesh
/// crosses ends there, or one of the two is short; the chain does not turn there by more than the
/// angle, short edges left out.
std::vector<EdgeChain> straightChains(const GroupingInput& input, const FaceGrouping& grouping);

}  // namespace af2::geometry
