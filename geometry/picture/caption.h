// The line of text under a picture of a mesh. Not installed.
#pragma once

#include <string>

#include "geometry/mesh/model_mesh.h"

namespace af2::geometry {

/// "10108 elements, lowest quality 0.76, 2 faces failed".
std::string captionOf(const ModelMesh& mesh);

}  // namespace af2::geometry
