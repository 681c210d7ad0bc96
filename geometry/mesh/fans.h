// Adds the ready-made elements of a face to those that a front has made.
// Not installed.
#pragma once

#include <cstddef>

#include "engine/mesh/mesh.h"
#include "engine/optimize/optimize.h"
#include "engine/surface/local_transform.h"
#include "geometry/mesh/face_boundary.h"

namespace af2::geometry {

double areaOfFans(const FaceBoundary& boundary);

/// `Quads`: triangles are joined in pairs where this gives sound quadrilaterals.
enum class FanElements { Triangles, Quads };

inline FanElements fanElementsFor(const QuadCleanUp& quads) {
  return quads.onlyQuads ? FanElements::Quads : FanElements::Triangles;
}

/// The tips become the last vertices of the boundary.
///
/// mesh    of the loops of the boundary
/// origin  of the elements of the fans
void addFans(FaceBoundary& boundary, FanElements kind, ElementOrigin origin, Mesh& mesh);

/// Joins triangles of the fans in pairs by moving the vertex of the rim between them away from the
/// tip, one after the other. Where the surface closes around a tip within a few elements, no chart
/// shows enough of it for joinTriangles.
///
/// mesh  to which addFans has added the fans of the boundary
/// Returns the number of pairs.
std::size_t joinAtTips(const FaceBoundary& boundary, const AF2LocalTransformMaker& charts,
                       Mesh& mesh);

/// The boundary of a mesh to which addFans has added the fans: around these, and not along their
/// rims.
MeshBoundary boundaryWithFans(const FaceBoundary& boundary);

}  // namespace af2::geometry
