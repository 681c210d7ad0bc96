// What it may cost to try again at faces that failed or came out poor, in candidates of the front.
// Not installed.
#pragma once

#include <cstddef>
#include <vector>

#include "geometry/mesh/face_mesh.h"

namespace af2::geometry {

/// What it costs to mesh a face again besides the candidates.
constexpr double kForEachFace = 1000;

/// Tries may cost some times as much as the mesh, but no more than about ten seconds.
///
/// share  of that which may be taken
double mostEffort(const std::vector<FaceMesh>& meshes, double share);

/// What faces that failed may take when they are meshed once more, all at the same time.
class RetryAllowance {
 public:
  /// again  the faces that are meshed once more; those of them count that failed
  /// left   for all of them
  RetryAllowance(const std::vector<FaceMesh>& meshes, const std::vector<std::size_t>& again,
                 double left);

  /// A face that failed may fail again, and shorter edges are dearer; but no more than its share of
  /// what is left, be it by number or by what it took before. Other faces take what they need.
  std::size_t mostCandidates(const FaceMesh& before) const;

 private:
  double left_;
  double faces_ = 0;   ///< so many there are
  double effort_ = 0;  ///< that they took before
};

}  // namespace af2::geometry
