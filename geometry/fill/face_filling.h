// Fills a face within its boundary, on any surface, and optimises and judges the mesh.
// Not installed.
#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "geometry/fill/fill_face.h"
#include "geometry/mesh/face_mesh.h"

namespace af2::geometry {

/// A face whose boundary is known.
struct FaceFilling {
  const FaceTask& task;
  const SizeField& wanted;   ///< before it is graded away from short segments
  double unseen = 0;         ///< narrower details are invisible in the mesh
  bool findMiddles = false;  ///< for elements of second order
  /// Sets the parameters of the places of a stuck front, if the surface has any.
  std::function<void(std::vector<StuckPlace>&)> findParameters = {};
  /// The smallest size that is allowed at a point; may be empty, then all are.
  std::function<double(const SurfacePoint&)> least = {};
  /// Makes `wanted` for another thread; may be empty, then all may use the same.
  std::function<std::shared_ptr<const SizeField>()> makeWanted = {};
};

/// Fills the face, optimises and judges the mesh, and stores the mesh, or the reason for its
/// failure, in `mesh`. The ways that were tried are added to the history of the mesh.
///
/// boundary  the boundary of the task; the mesh takes over its lists of points and uses
///
/// Throws GeometryError with the reason if nothing works.
void fillAndJudge(const FaceFilling& filling, FaceBoundary& boundary, FaceMesh& mesh);

/// Turns the mesh into that of a failed face.
void failFor(const std::string& reason, FaceMesh& mesh);

}  // namespace af2::geometry
