// Where the mesh of a face is missing or poor, and how short edges should be there.
// Not installed.
#pragma once

#include <string>
#include <vector>

#include "engine/run/algorithm.h"
#include "geometry/base/plane_axes.h"
#include "geometry/charts/charted_surface.h"
#include "geometry/mesh/face_boundary.h"
#include "geometry/mesh/face_diagnosis.h"

namespace af2::geometry {

/// Where a front got stuck, where a mesh has faults, and where the segments of the boundary cross.
/// May be nowhere.
FaceDiagnosis diagnoseFailure(const ChartedSurface& surface, const FaceBoundary& boundary,
                              const std::vector<MeshingResult>& results);

/// Elements with tiny angles that shorter edges could open, and faces that straight edges cut too
/// much off from.
///
/// area    of the face; 0: unknown
/// unseen  what is narrower than this is not to be seen in the mesh
FaceDiagnosis diagnoseMesh(const Mesh& mesh, const FaceBoundary& boundary, bool isPlane,
                           double area, double unseen);

/// The area of the elements of a mesh.
double areaOfElements(const Mesh& mesh);

/// Draws the boundary of a face in a plane: for a plane, that itself; else its parameters, scaled
/// to a common unit of length. A reversed face comes out mirrored, so that its loops still run with
/// the region on their left.
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
