// Irregular vertices of a mesh, and the directions in which edges leave smooth boundaries.
// Not installed.
#pragma once

#include <cstdint>
#include <vector>

#include "geometry/quality/mesh_fans.h"
#include "geometry/quality/mesh_measures.h"

namespace af2::geometry {

enum class VertexState : std::uint8_t { Unused, Regular, Irregular };

/// By vertex.
std::vector<VertexState> vertexStates(const ModelMesh& mesh, const MeshFans& fans);

/// distance  by vertex: the number of edges to the nearest boundary
IrregularVertices countIrregularVertices(const ModelMesh& mesh, const MeshFans& fans,
                                         const std::vector<VertexState>& states,
                                         const std::vector<std::uint32_t>& distance);

/// By edge that leaves a smooth boundary (a vertex with an interior angle of 150 to 210 degrees)
/// inward: the angle in degrees between it and the nearest direction of a regular mesh, in the
/// surface. In a face of quadrilaterals this direction is the normal of the boundary; in a face of
/// triangles there are two, which divide the interior angle in three.
std::vector<double> spokeDeviations(const ModelMesh& mesh, const MeshFans& fans);

}  // namespace af2::geometry
