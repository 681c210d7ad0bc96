// A remedy: faces that touch each other and have an edge inside in common get different ones.
// Not installed.
#pragma once

#include <cstddef>
#include <vector>

#include "geometry/check/sound_faces.h"
#include "geometry/edges/divided_edges.h"
#include "geometry/mesh/face_mesh.h"

namespace af2::geometry {

/// Where edges inside two faces have the same two ends, as where both close a corner with the same
/// triangle or bridge the same narrow place, there are four elements at one edge; more than its
/// faces have at a segment between the same ends. In all of these faces but one, the edge is
/// swapped for the other diagonal of its two triangles, if that makes sound elements; first where
/// the worse angle of both is larger. Elements of second order stay as they are.
/// Returns how many were swapped.
std::size_t splitSharedDiagonals(const DividedEdges& divided, std::vector<FaceMesh>& meshes);

bool hasFindings(const MeshFaults& faults);
/// And no more elements that cross.
bool hasFewerFindings(const MeshFaults& before, const MeshFaults& after);

}  // namespace af2::geometry
