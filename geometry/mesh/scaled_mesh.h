// A mesh in another unit of length.
#pragma once

#include "engine/base/export.h"
#include "geometry/mesh/model_mesh.h"

namespace af2::geometry {

/// All coordinates, lengths and areas that files of meshes have, multiplied by `factor` (> 0) or by
/// its square. Contacts, healing and texts stay as they are.
AF2_EXPORT ModelMesh scaledMesh(ModelMesh mesh, double factor);

}  // namespace af2::geometry
