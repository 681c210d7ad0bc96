// The last smoothing of meshes with quadrilaterals: the sharpest and widest corners.
#pragma once

#include <cstddef>

#include "engine/base/work_watch.h"
#include "engine/mesh/mesh_topology.h"
#include "engine/optimize/act_recorder.h"
#include "engine/surface/local_transform.h"

namespace af2 {

/// Moves inner vertices of quadrilaterals with a scaled Jacobian below 0.9 to places where the
/// smallest one around the vertex is larger. Where sides differ in length, smoothing by other
/// measures evens these at the cost of the corners. Here corners count, as long as the sides do not
/// differ by more than a factor of 2, or than they did.
///
/// Goes on until no vertex gains any more, for at most a fixed number of sweeps. Returns the number
/// of moves.
std::size_t mendCorners(const MeshTopology& topology, Mesh& mesh,
                        const AF2LocalTransformMaker& maker, ActRecorder* recorder,
                        const WorkWatch& watch);

}  // namespace af2
