// The directed loops around a face of a domain, made of divided curves.
// Not installed.
#pragma once

#include "geometry/domain/domain_model.h"
#include "geometry/edges/divided_edges.h"
#include "geometry/mesh/face_boundary.h"

namespace af2::geometry {

/// Throws GeometryError if a point of the boundary is not on the surface.
FaceBoundary boundaryOf(const DomainFace& face, const DividedEdges& divided);

}  // namespace af2::geometry
