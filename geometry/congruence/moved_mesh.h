// Moves the mesh of a face onto a congruent one. Not installed.
#pragma once

#include <vector>

#include "geometry/congruence/face_outline.h"
#include "geometry/mesh/face_mesh.h"

namespace af2::geometry {

/// The mesh of a face that other faces may take over.
class MovableMesh {
 public:
  /// Whether a mesh is complete.
  static bool isMovable(const FaceMesh& mesh);

  /// outline, mesh  of the same face; kept as references
  MovableMesh(const FaceOutline& outline, const FaceMesh& mesh);

  /// Gives a face this mesh, if the face is congruent and wants the same sizes. `into` has the
  /// report of the face already.
  bool moveTo(const FaceOutline& other, FaceMesh& into) const;

 private:
  std::vector<double> mostByPosition(const std::vector<Point3>& places,
                                     const PositionSize& sizes) const;
  bool isSurfaceMoved(const FaceOutline& other, const std::vector<Point3>& inside,
                      const Congruence& congruence) const;
  bool wantsSameSizes(const std::vector<Point3>& places, const PositionSize& sizes) const;

  const FaceOutline& outline_;
  const FaceMesh& mesh_;
  std::vector<double> byPosition_;  ///< by vertex: the size by position, if it is not far above
};

}  // namespace af2::geometry
