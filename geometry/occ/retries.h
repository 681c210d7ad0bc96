// Faces that failed or came out poor are tried again with shorter edges.
// Not installed: includers need OpenCASCADE's headers.
#pragma once

#include <functional>
#include <vector>

#include "geometry/element_crossings.h"
#include "geometry/occ/edge_division.h"
#include "geometry/occ/face_mesher.h"

namespace af2::geometry {

/// A division of the edges and the meshes made within it.
struct FaceMeshes {
  DividedEdges divided;
  std::vector<FaceMesh> meshes;     ///< by face that was asked for
  ModelMesh joined;                 ///< of all of them
  std::vector<Crossing> crossings;  ///< of its elements
};

struct RetryTask {
  const ModelShape& model;
  const ModelMeshingOptions& options;  ///< with sizes that are ready for use
  const std::vector<int>& faces;       ///< that were asked for
  /// Meshes the i-th of these within the edges of `into`; fronts that have examined
  /// `mostCandidates` are given up. Called from several threads at once.
  std::function<void(std::size_t i, const ModelMeshingOptions& options, std::size_t mostCandidates,
                     FaceMeshes& into)>
      mesh;
  /// Meshes the i-th of these with elements that lean against the surface.
  std::function<void(std::size_t i, FaceMeshes& into)> meshLeaning;
  std::function<void(FaceMeshes& state)> join;  ///< joins the meshes and finds their crossings
};

/// Where faces failed, came out poor or cross each other, tries again with shorter edges around the
/// places at fault, as long as that brings something and costs no more than some times the mesh
/// itself. Faces beside edges that are divided anew are meshed anew. Leaves the best of all tries,
/// joined.
void retryPoorFaces(const RetryTask& task, FaceMeshes& state);

}  // namespace af2::geometry
