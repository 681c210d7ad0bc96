// Moves inner vertices to where the elements around them are least distorted.
#pragma once

#include "engine/local_transform.h"
#include "engine/mesh_topology.h"
#include "engine/size_field.h"

namespace af2 {

/// One sweep over all inner vertices in order. Returns how many were moved.
std::size_t smoothVertices(MeshTopology& topology, Mesh& mesh, const AF2LocalTransformMaker& maker,
                           const SizeField& size);

}  // namespace af2
