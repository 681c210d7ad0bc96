// Checks of the files that `af2 mesh` is to write, before the model is meshed.
#pragma once

#include <string>

#include "cli/meshing/mesh_request.h"

namespace af2::cli {

/// The extensions of the formats that can hold something.
std::string extensionsThat(bool geometry::MeshFormat::*holds, const char* conjunction);

/// Throws UsageError for files that cannot be written, or cannot hold what was asked for.
void checkOutputs(const MeshRequest& request);

}  // namespace af2::cli
