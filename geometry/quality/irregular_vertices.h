// Irregular vertices of a mesh, and the directions in which edges leave smooth boundaries.
// Not installed.
#pragma once

#include <vector>

#include "geometry/quality/mesh_fans.h"
#include "geometry/quality/mesh_measures.h"

namespace af2::geometry {

IrregularVertices findIrregularVertices(const ModelMesh& mesh, const MeshFans& fans);

/// By edge that leaves a smooth boundary (a vertex with an interior angle of 150 to 210 degrees)
/// inward: the angle in degrees between it and the nearest direction of a regular mesh, in the
/// surface. In a face of quadrilaterals this direction is the normal of the boundary; in a face of
/// triangles there are two, which divide the interior angle in three.
std::vector<double> spokeDeviations(const ModelMesh& mesh, const MeshFans& fans);

}  // namespace af2::geometry
