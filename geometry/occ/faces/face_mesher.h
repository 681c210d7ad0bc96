// Meshes one face within its divided edges.
// Not installed: includers need OpenCASCADE's headers.
#pragma once

#include <limits>

#include "geometry/mesh/face_mesh.h"
#include "geometry/occ/edges/edge_division.h"
#include "geometry/occ/faces/face_boundary.h"
#include "geometry/occ/model/meshing_options.h"

namespace af2::geometry {

/// What all faces of a run share.
struct FaceMeshingContext {
  const ModelShape& model;
  const AF2Algorithm& algorithm;
  const ModelMeshingOptions& options;
  const DividedEdges& divided;
  const std::vector<FaceOnFace>& onFaces;
  ProgressCallback progress;
  /// Whether sizes inside a face may be much smaller than along its boundary.
  bool mayBeFineInside = false;
  /// A front that has examined more candidates than these is given up.
  std::size_t mostCandidates = std::numeric_limits<std::size_t>::max();
  /// Whether elements may lean against the surface as they like: all else has failed.
  bool mayLean = false;
};

/// Never throws for a fault of the face: that becomes a failed report.
FaceMesh meshFace(const FaceMeshingContext& context, int face, double area,
                  double expectedElements);

}  // namespace af2::geometry
