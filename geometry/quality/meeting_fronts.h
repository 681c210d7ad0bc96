// Where fronts from the boundaries meet, and how the mesh is there.
// Not installed.
#pragma once

#include <cstdint>
#include <vector>

#include "geometry/quality/boundary_distance.h"
#include "geometry/quality/irregular_vertices.h"
#include "geometry/quality/mesh_measures.h"

namespace af2::geometry {

/// distance   by vertex: the number of edges to the nearest boundary
/// jacobians  by element
MeetingFronts measureMeetingFronts(const ModelMesh& mesh, const VertexNeighbors& neighbors,
                                   const std::vector<std::uint32_t>& distance,
                                   const std::vector<VertexState>& states,
                                   const std::vector<double>& jacobians);

}  // namespace af2::geometry
