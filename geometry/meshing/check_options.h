// Whether what is wanted of a mesh makes sense for a model. Not installed.
#pragma once

#include <vector>

#include "geometry/meshing/face_source.h"

namespace af2::geometry {

/// Throws InputError for an option that makes no sense, and for an id that the model does not have.
void checkOptions(const FaceSource& source, const MeshingOptions& options);

/// The options with sizes by face instead of those by name, and none larger than the model.
///
/// Throws InputError if no face or group has the name.
MeshingOptions optionsFor(const FaceSource& source, MeshingOptions options);

/// All faces that are asked for, ascending.
std::vector<int> facesAskedFor(const FaceSource& source, const MeshingOptions& options);

}  // namespace af2::geometry
