// Detects closed meshes whose elements face inwards.
#pragma once

#include "geometry/mesh/model_mesh.h"

namespace af2::geometry {

/// The note for such a mesh.
constexpr const char* kInsideOut =
    "the surface is closed and faces inwards: the elements are clockwise as seen from outside";

/// Whether a mesh is closed, its elements are oriented alike, and they are clockwise seen from
/// outside: the model is inside out. False if any face failed.
bool isInsideOut(const ModelMesh& mesh);

}  // namespace af2::geometry
