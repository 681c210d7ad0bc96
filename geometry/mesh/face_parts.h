// Joins the meshes of a face that is meshed in parts, along lines that are not its edges.
// Not installed.
#pragma once

#include <vector>

#include "geometry/mesh/face_mesh.h"

namespace af2::geometry {

/// Makes one mesh of the parts of a face. The entries of the report on the face itself stay. The
/// face has failed if one of its parts has failed.
void joinParts(std::vector<FaceMesh> parts, FaceMesh& mesh);

}  // namespace af2::geometry
