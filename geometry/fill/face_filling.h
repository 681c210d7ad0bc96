// From the boundary of a face to its mesh, on whatever surface: filled, optimised and judged.
// Not installed.
#pragma once

#include <functional>

#include "geometry/fill/fill_face.h"
#include "geometry/mesh/face_mesh.h"

namespace af2::geometry {

/// A face whose boundary is known.
struct FaceFilling {
  const FaceTask& task;
  const SizeField& wanted;   ///< before it is graded away from short segments
  double unseen = 0;         ///< what is narrower than this is not to be seen in the mesh
  bool findMiddles = false;  ///< for elements of second order
  /// Gives the places of a stuck front their parameters, if the surface has any.
  std::function<void(std::vector<StuckPlace>&)> findParameters = {};
};

/// Fills the face, optimises and judges the mesh, and takes it over; or what kept it from being
/// made. What was tried joins the history of the mesh.
///
/// boundary  that of the task, whose lists of points and uses the mesh takes over
///
/// Throws GeometryError with the reason if nothing works.
void fillAndJudge(const FaceFilling& filling, FaceBoundary& boundary, FaceMesh& mesh);

/// The mesh so far becomes that of a face that failed.
void failFor(const std::string& reason, FaceMesh& mesh);

}  // namespace af2::geometry
