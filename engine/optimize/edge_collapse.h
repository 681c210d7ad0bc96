// Takes out inner vertices that their neighbours do better without.
#pragma once

#include "engine/mesh/mesh_topology.h"

namespace af2 {

/// One sweep over all inner vertices in order. Returns how many were taken out.
std::size_t collapseEdges(MeshTopology& topology);

}  // namespace af2
