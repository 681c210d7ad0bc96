// Meshes that are put on disk face by face: --stream.
#pragma once

#include "cli/meshing/mesh_request.h"

namespace af2::cli {

/// Always if that is asked for; else if it is needed, where nothing speaks against it. The faces
/// are kept in the folder of the first file that is written.
///
/// Throws UsageError if it is asked for and something speaks against it.
geometry::SpoolRequest checkedStream(bool isAsked, const MeshRequest& request);

}  // namespace af2::cli
