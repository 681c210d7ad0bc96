// Removes inner vertices where that improves the mesh.
#pragma once

#include "engine/base/work_watch.h"
#include "engine/mesh/mesh_topology.h"
#include "engine/optimize/act_recorder.h"

namespace af2 {

/// One sweep over all inner vertices in order; ends early if a stop is requested. Returns the
/// number of removed vertices.
std::size_t collapseEdges(MeshTopology& topology, ActRecorder* recorder = nullptr,
                          const WorkWatch& watch = {});

}  // namespace af2
