// The checks of a whole mesh that lies on disk.
// Not installed.
#pragma once

#include <memory>
#include <vector>

#include "geometry/check/face_evidence.h"
#include "geometry/check/sound_faces.h"

namespace af2::geometry {

/// By part of ModelMesh::spooled.
using EvidenceOfParts = std::vector<std::shared_ptr<const FaceEvidence>>;

/// What `faultsOf` finds in the same mesh in memory. At most two faces for each thread are loaded
/// at once, and those that are not sound inside.
MeshFaults faultsOfSpooled(const ModelMesh& mesh, const EvidenceOfParts& evidence, bool mayCross,
                           int threads);

}  // namespace af2::geometry
