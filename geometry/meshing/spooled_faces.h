// Puts the meshes of faces on disk when they are done.
// Not installed.
#pragma once

#include <memory>

#include "geometry/check/spooled_faults.h"
#include "geometry/mesh/face_mesh.h"

namespace af2::geometry {

/// Checks a face by itself and puts its bulk into the file. Nothing to do if it has none, or if
/// that is on disk already.
void spoolFace(FaceMesh& mesh, const DividedEdges& divided, bool mayCross,
               const std::shared_ptr<SpoolFile>& file);

/// In the order of the parts of the joined mesh.
EvidenceOfParts evidenceOf(const std::vector<FaceMesh>& meshes);

}  // namespace af2::geometry
