// Smaller sizes on faces that cannot be meshed with those that are asked for.
// Not installed.
#pragma once

#include <functional>

#include "geometry/mesh/model_mesh.h"
#include "geometry/meshing/face_source.h"

namespace af2::geometry {

/// Makes a mesh. If coarse faces fail in it and the model does not explain why, they are tried
/// alone, with a quarter and then a half or an eighth of their sizes; if some of them can be meshed
/// so, the mesh is made again with these sizes, and kept if fewer faces fail. A note says so.
ModelMesh meshFinerWhereFailed(const FaceSource& source, MeshingOptions options,
                               const std::function<ModelMesh(const MeshingOptions&)>& make);

}  // namespace af2::geometry
