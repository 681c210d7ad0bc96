// Removes inner vertices where that improves the mesh.
#pragma once

#include "engine/mesh/mesh_topology.h"
#include "engine/optimize/act_recorder.h"

namespace af2 {

/// One sweep over all inner vertices in order. Returns the number of removed vertices.
std::size_t collapseEdges(MeshTopology& topology, ActRecorder* recorder = nullptr);

}  // namespace af2
