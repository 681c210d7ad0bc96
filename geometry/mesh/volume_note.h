// Compares the volume that a mesh encloses with that of its model.
// Not installed.
#pragma once

#include <string>

#include "geometry/mesh/model_mesh.h"

namespace af2::geometry {

/// A note if a closed mesh encloses a volume that differs from `wanted` by more than 2 %; empty if
/// not. Elements that are large beside the bends of a surface cut off what is outside of them.
///
/// of  whose volume is wanted, such as "the triangles of the file"
std::string volumeNote(const ModelMesh& mesh, double wanted, const std::string& of);

}  // namespace af2::geometry
