// Checks the options of a mesh against the model. Not installed.
#pragma once

#include <string>
#include <vector>

#include "geometry/meshing/face_source.h"
#include "geometry/sizes/too_many.h"

namespace af2::geometry {

/// Of a run with these options.
MemoryLimit memoryLimitOf(const MeshingOptions& options);

/// What hinders a mesh from being put on disk, as the rest of a sentence; empty: nothing does.
std::string whyNotSpooled(const MeshingOptions& options);

/// Throws InputError for an invalid option, and for an id that the model does not have.
void checkOptions(const FaceSource& source, const MeshingOptions& options);

/// The options with faces, and sizes by face, instead of names, and no size larger than the model.
///
/// Throws InputError if no face or group has the name.
MeshingOptions optionsFor(const FaceSource& source, MeshingOptions options);

/// All requested faces, ascending.
std::vector<int> facesAskedFor(const FaceSource& source, const MeshingOptions& options);

}  // namespace af2::geometry
