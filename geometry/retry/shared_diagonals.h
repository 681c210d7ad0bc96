// A remedy: swaps diagonals where two touching faces have the same edge inside.
// Not installed.
#pragma once

#include <cstddef>
#include <vector>

#include "geometry/check/sound_faces.h"
#include "geometry/edges/divided_edges.h"
#include "geometry/mesh/face_mesh.h"

namespace af2::geometry {

/// Where edges inside two faces have the same two ends, for example because both close a corner
/// with the same triangle or bridge the same narrow place, one edge has four elements, which is
/// also too many if a segment has the same ends. In all of these faces except one, the edge is
/// swapped for the other diagonal of its two triangles, if the new elements are valid; the faces in
/// which the smallest resulting angle is larger come first. Elements of second order are not
/// changed. Returns the number of swapped edges.
std::size_t splitSharedDiagonals(const DividedEdges& divided, std::vector<FaceMesh>& meshes);

bool hasFindings(const MeshFaults& faults);
/// Whether there are fewer findings, and no more crossing elements.
bool hasFewerFindings(const MeshFaults& before, const MeshFaults& after);

}  // namespace af2::geometry
