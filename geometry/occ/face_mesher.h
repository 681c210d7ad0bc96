// Meshes one face within its divided edges.
// Not installed: includers need OpenCASCADE's headers.
#pragma once

#include <limits>

#include "geometry/occ/edge_division.h"
#include "geometry/occ/face_boundary.h"
#include "geometry/occ/face_trouble.h"
#include "geometry/occ/mesh_model.h"
#include "geometry/second_order.h"

namespace af2::geometry {

/// The mesh of a face. Corners of elements are numbered: first the vertices of the boundary, then
/// those inside.
struct FaceMesh {
  FaceReport report;
  std::vector<std::uint32_t> boundary;  ///< indices into DividedEdges::points
  std::vector<Point3> inside;
  std::vector<double> wantedSizes;  ///< by vertex
  std::vector<Element> elements;
  std::vector<std::uint16_t> rule;
  std::vector<SideMiddles> middles;  ///< by element; only for elements of second order
  std::vector<SegmentUse> uses;
  double optimizeSeconds = 0;  ///< part of report.seconds
  FaceTrouble trouble;
  std::size_t effort = 0;  ///< candidates of the front, those in vain too
};

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
