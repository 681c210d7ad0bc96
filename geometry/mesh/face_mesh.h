// The mesh of one face of a model, before it is joined with the others.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <vector>

#include "geometry/edges/divided_edges.h"
#include "geometry/mesh/face_boundary.h"
#include "geometry/mesh/face_diagnosis.h"
#include "geometry/mesh/face_history.h"
#include "geometry/mesh/model_mesh.h"
#include "geometry/mesh/second_order.h"

namespace af2::geometry {

/// Corners of elements are numbered: first the vertices of the boundary, then those inside.
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
  FaceDiagnosis diagnosis;
  FaceHistory history;         ///< `report.attempts` is made from it once all has been tried
  std::size_t searchCost = 0;  ///< candidates of the front, those in vain too
};

/// Whether a face has no mesh, or one that will not pass the checks.
inline bool failed(const FaceMesh& mesh) {
  return mesh.report.status == FaceStatus::Failed || mesh.diagnosis.hasWrongArea;
}

/// Whether more than a few elements have sides several times as long as what is wanted at their
/// ends, and as the segments of the boundary there: they span what they should have followed.
bool reachesTooFar(const FaceMesh& mesh, const DividedEdges& divided);

/// By id of the face, where the middles of the sides of its elements lie.
using MiddlesByFace = std::map<int, std::vector<SideMiddles>>;
MiddlesByFace takeMiddles(std::vector<FaceMesh>& meshes);
/// Of the elements that are still there after the checks, in their order.
std::vector<SideMiddles> middlesOf(const ModelMesh& mesh, const MiddlesByFace& byFace);

/// The part of the time that optimising took, where faces are meshed one beside the other.
double shareOfOptimizing(const std::vector<FaceMesh>& meshes);

}  // namespace af2::geometry
