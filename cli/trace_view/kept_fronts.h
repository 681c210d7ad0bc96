// Which fronts the mesh of a run consists of: a face may be attempted several times.
#pragma once

#include "cli/trace_view/face_record.h"
#include "geometry/mesh/model_mesh.h"

namespace af2::cli {

/// Sets ViewFront::kept, and ends the elements of fronts that were not kept when the next front
/// begins.
///
/// A front was kept if most of its inner vertices are vertices of the mesh. A face that was laid
/// out in a plane or has no inner vertices has no such front; then the only front that closed was
/// kept; of several, the only one with as many elements as the face has in the mesh; or the last
/// one, if all have the same vertices.
void markKeptFronts(const geometry::ModelMesh& mesh, std::vector<FaceRecord*>& faces);

}  // namespace af2::cli
