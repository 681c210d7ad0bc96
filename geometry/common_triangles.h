// Two faces that touch each other in a corner may close it with the same triangle.
// Not installed.
#pragma once

#include <vector>

#include "geometry/divided_edges.h"
#include "geometry/face_mesh.h"

namespace af2::geometry {

/// Where two faces have a triangle with the same three corners, there is nothing between them, and
/// their common side has four elements. In one of them, the side inside the face is swapped for the
/// other diagonal, if that makes sound elements; first where the worse angle of both is larger.
/// Elements of second order stay as they are.
void partCommonTriangles(const DividedEdges& divided, std::vector<FaceMesh>& meshes);

}  // namespace af2::geometry
