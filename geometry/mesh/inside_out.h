// Closed meshes that look inwards.
#pragma once

#include "geometry/mesh/model_mesh.h"

namespace af2::geometry {

/// What is noted of such a mesh.
constexpr const char* kInsideOut =
    "the surface is closed and looks inwards: the elements run clockwise seen from outside";

/// Whether a mesh is closed, all neighbours turned alike, and its elements run clockwise seen from
/// outside: the model was turned inside out. False if any face failed.
bool isInsideOut(const ModelMesh& mesh);

}  // namespace af2::geometry
