// Where the mesh of a face is missing or poor, and how short edges should be there.
// Not installed.
#pragma once

#include <string>
#include <vector>

#include "engine/algorithm.h"
#include "geometry/charted_surface.h"
#include "geometry/face_boundary.h"
#include "geometry/graded_size.h"
#include "geometry/plane_axes.h"

namespace af2::geometry {

/// Places that want shorter edges, and how far from acceptable a mesh is: 0 is good enough.
struct FaceTrouble {
  std::vector<SizeSource> places;
  double poorness = 0;
  bool isBad = false;         ///< not fit for use; else it could be nicer, but not at any price
  bool hasBadAngle = false;   ///< one that makes an element hardly of use
  bool hasWrongArea = false;  ///< no check would let the mesh pass
};

/// Where a front got stuck, where a mesh has faults, and where the segments of the boundary cross.
/// May be nowhere.
FaceTrouble troubleOfFailure(const ChartedSurface& surface, const FaceBoundary& boundary,
                             const std::vector<MeshingResult>& results);

/// Elements with tiny angles that shorter edges could open, and faces that straight edges cut too
/// much off from.
///
/// area    of the face; 0: unknown
/// unseen  what is narrower than this is not to be seen in the mesh
FaceTrouble troubleOfMesh(const Mesh& mesh, const FaceBoundary& boundary, bool isPlane, double area,
                          double unseen);

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
