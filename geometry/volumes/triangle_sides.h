// Connects the sides of triangles that look into the same cell of space across an edge.
// Not installed.
#pragma once

#include <cstdint>
#include <vector>

#include "geometry/volumes/mesh_cells.h"

namespace af2::geometry {

/// By side of a triangle, as in MeshCells::ofSide: the lowest side that is connected to it. Sides
/// are connected if a path over triangles and around their edges leads from one to the other.
std::vector<std::uint32_t> connectedSides(const std::vector<Point3>& vertices,
                                          const std::vector<Triangle>& triangles);

}  // namespace af2::geometry
