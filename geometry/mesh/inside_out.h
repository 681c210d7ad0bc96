// Detects closed meshes whose elements face inwards.
#pragma once

#include <functional>
#include <optional>

#include "geometry/mesh/model_mesh.h"

namespace af2::geometry {

/// The note for such a mesh.
constexpr const char* kInsideOut =
    "the surface is closed and faces inwards: the elements are clockwise as seen from outside";

/// The volume that a mesh encloses, negative if it is inside out. None if the mesh is not closed, a
/// face failed or was left out, or its elements are not oriented alike.
std::optional<double> enclosedVolume(const ModelMesh& mesh);

/// The same; also none if the volume is one that does not matter. Then it is not found out how the
/// elements are oriented, which takes longer than the volume.
std::optional<double> enclosedVolumeIf(const ModelMesh& mesh,
                                       const std::function<bool(double)>& matters);

/// Whether a mesh is closed, its elements are oriented alike, and they are clockwise seen from
/// outside: the model is inside out. False if any face failed.
bool isInsideOut(const ModelMesh& mesh);

}  // namespace af2::geometry
