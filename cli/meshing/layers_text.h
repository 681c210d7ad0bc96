// What there is to say about layers along edges.
#pragma once

#include <string>

#include "geometry/mesh/model_mesh.h"

namespace af2::cli {

/// The number of their elements, and where there are fewer layers than asked; empty if none were
/// asked for.
std::string layersText(const geometry::ModelMesh& mesh);

}  // namespace af2::cli
