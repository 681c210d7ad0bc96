// A face that is meshed in several parts, between lines that are none of its own edges.
// Not installed.
#pragma once

#include <vector>

#include "geometry/mesh/face_mesh.h"

namespace af2::geometry {

/// Makes one mesh of the parts of a face. What the report says of the face itself stays. It has
/// failed if one of its parts has.
void joinParts(std::vector<FaceMesh> parts, FaceMesh& mesh);

}  // namespace af2::geometry
