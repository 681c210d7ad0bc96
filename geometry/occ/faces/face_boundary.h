// Makes the directed loops around a face from the divided edges.
// Not installed: includers need OpenCASCADE's headers.
#pragma once

#include "geometry/mesh/face_boundary.h"
#include "geometry/occ/edges/edge_division.h"
#include "geometry/occ/faces/faces_on_faces.h"
#include "geometry/occ/surfaces/face_surface.h"

namespace af2::geometry {

/// onFaces  the folded-back faces on this face, whose area is excluded from it
///
/// Throws GeometryError, saying which edge is at fault, if the face has no closed boundary.
FaceBoundary findBoundary(const ModelShape& model, int face, const DividedEdges& divided,
                          const FaceSurface& surface, const std::vector<FaceOnFace>& onFaces = {});

/// The boundary of one cell of a creased face. It has no loops if the face has no part there.
///
/// surface  that of the cell
FaceBoundary findBoundary(const ModelShape& model, int face, const FaceCell& cell,
                          const DividedEdges& divided, const FaceSurface& surface);

}  // namespace af2::geometry
