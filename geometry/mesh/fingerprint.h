// A hash of a mesh, for comparing runs.
#pragma once

#include <string>

#include "engine/base/export.h"
#include "geometry/mesh/model_mesh.h"

namespace af2::geometry {

/// 16 hexadecimal digits: the 64-bit xxHash of the bytes of all vertices, then of all elements.
AF2_EXPORT std::string fingerprint(const ModelMesh& mesh);

}  // namespace af2::geometry
