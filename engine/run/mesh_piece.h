// Meshes a region, or a piece of one, by a single front.
// Not installed.
#pragma once

#include "engine/run/mesh_region.h"

namespace af2 {

/// See meshRegion. A front whose mesh is not sound is advanced a second time in another way.
///
/// input  the boundary of the piece
RegionMesh meshPiece(const AF2Algorithm& algorithm, const RegionTask& task, const FrontInput& input,
                     const FrontOptions& options);

}  // namespace af2
