// What a page says about a mesh besides its arrays. Not installed.
#pragma once

#include <string>

#include "geometry/mesh/model_mesh.h"

namespace af2::geometry {

/// JSON that can stand inside an element `script` of a page: names, rules, faces and groups.
///
/// centre  the point of the model that is the origin of the page's coordinates
std::string pageInfo(const ModelMesh& mesh, const Point3& centre, int cornersPerElement);

}  // namespace af2::geometry
