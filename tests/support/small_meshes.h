// Meshes to write and to measure.
#pragma once

#include "geometry/mesh/model_mesh.h"

namespace af2::geometry {

/// The cube [0, 1]^3: faces 1 to 5 of two triangles each, face 6 (the top, "lid") one
/// quadrilateral.
ModelMesh cubeMesh();

/// One element with these corners, on face 1.
ModelMesh oneElement(std::vector<Point3> corners);

}  // namespace af2::geometry
