// Finds where the mesh of a face is missing or poor, and how short edges should be there.
// Not installed.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "engine/run/algorithm.h"
#include "geometry/base/plane_axes.h"
#include "geometry/charts/charted_surface.h"
#include "geometry/mesh/face_boundary.h"
#include "geometry/mesh/face_diagnosis.h"

namespace af2::geometry {

/// Whether the wanted size at a point is the smallest that is allowed there. An edge with two such
/// ends cannot become shorter, so it is no place to ask for that.
using IsLeast = std::function<bool(const SurfacePoint&)>;

/// Where a front got stuck, where a mesh has faults, and where the segments of the boundary cross.
/// May contain no places.
FaceDiagnosis diagnoseFailure(const ChartedSurface& surface, const FaceBoundary& boundary,
                              const std::vector<MeshingResult>& results);

/// Elements with tiny angles that shorter edges could open, and faces from whose area straight
/// edges cut off too much.
///
/// area     of the face; 0: unknown
/// unseen   narrower details are invisible in the mesh
/// isLeast  may be empty
FaceDiagnosis diagnoseMesh(const Mesh& mesh, const FaceBoundary& boundary, bool isPlane,
                           double area, double unseen, const IsLeast& isLeast);

/// Adds the triangles of a mesh that should have none: shorter edges could give room to join them.
void askForRoom(const Mesh& mesh, const IsLeast& isLeast, FaceDiagnosis& diagnosis);

/// The area of the elements of a mesh.
double areaOfElements(const Mesh& mesh);

/// Maps the boundary of a face to a plane: the face's own plane, or its parameters, scaled to a
/// common unit of length. A reversed face is mirrored, so that its loops still have the region on
/// their left.
class BoundaryPicture {
 public:
  BoundaryPicture(const ChartedSurface& surface, const FrontInput& boundary);
  Point2 operator()(const SurfacePoint& point) const;

 private:
  bool isPlane_;
  PlaneAxes axes_;
  double u_ = 1, v_ = 1;
};

}  // namespace af2::geometry
