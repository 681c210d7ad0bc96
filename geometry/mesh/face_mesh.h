// The mesh of one face of a model, before it is joined with the others.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <vector>

#include "geometry/edges/divided_edges.h"
#include "geometry/mesh/face_boundary.h"
#include "geometry/mesh/face_diagnosis.h"
#include "geometry/mesh/face_history.h"
#include "geometry/mesh/model_mesh.h"
#include "geometry/mesh/second_order.h"
#include "geometry/spool/spooled_face.h"

namespace af2::geometry {

struct FaceEvidence;

/// Corners of elements are numbered: first the vertices of the boundary, then those inside.
struct FaceMesh {
  FaceReport report;
  std::vector<std::uint32_t> boundary;  ///< indices into DividedEdges::points
  std::vector<Point3> inside;
  std::vector<double> wantedSizes;  ///< by vertex
  std::vector<Element> elements;
  std::vector<ElementOrigin> origins;  ///< by element
  std::vector<SideMiddles> middles;    ///< by element; only for elements of second order
  std::vector<SegmentUse> uses;
  bool hasVanished = false;    ///< all its edges are points, so that its neighbours meet in one
  double optimizeSeconds = 0;  ///< part of report.seconds
  FaceDiagnosis diagnosis;
  FaceHistory history;         ///< `report.attempts` is made from it once all has been tried
  std::size_t searchCost = 0;  ///< candidates of the front, with those of failed attempts
  /// Vertices inside and elements, if they are on disk: then `inside`, `elements` and `origins` are
  /// empty, and `wantedSizes` has the vertices of the boundary only.
  std::shared_ptr<const StoredFace> bulk = {};
  std::shared_ptr<const FaceEvidence> evidence = {};  ///< what the checks need to know of these
};

inline std::size_t elementCount(const FaceMesh& mesh) {
  return mesh.bulk ? mesh.bulk->counts().elements : mesh.elements.size();
}

/// Brings the bulk back into memory, if it is on disk.
void loadBulk(FaceMesh& mesh);

/// Whether a face has no mesh, or a mesh that will not pass the checks.
inline bool failed(const FaceMesh& mesh) {
  return mesh.report.status == FaceStatus::Failed || mesh.diagnosis.hasWrongArea;
}

/// Whether more than a few elements have sides several times as long as the sizes wanted at their
/// ends, and as the segments of the boundary there: they span details that they should have
/// followed.
bool reachesTooFar(const FaceMesh& mesh, const DividedEdges& divided);

/// By id of the face: the positions of the middles of the sides of its elements.
using MiddlesByFace = std::map<int, std::vector<SideMiddles>>;
MiddlesByFace takeMiddles(std::vector<FaceMesh>& meshes);
/// The middles for the elements that remain after the checks, in their order.
std::vector<SideMiddles> middlesOf(const ModelMesh& mesh, const MiddlesByFace& byFace);

/// The share of the time that optimising took, if faces are meshed in parallel.
double shareOfOptimizing(const std::vector<FaceMesh>& meshes);

}  // namespace af2::geometry
