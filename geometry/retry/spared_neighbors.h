// The faces beside those for whose sake edges are divided anew.
// Not installed.
#pragma once

#include <functional>
#include <vector>

#include "geometry/mesh/face_mesh.h"
#include "geometry/retry/refinement.h"

namespace af2::geometry {

/// Sees to it that shorter edges for the sake of one face do not spoil those beside it: where
/// curves touch at an angle of zero, the element there is the worse the shorter it is.
class SparedNeighbors {
 public:
  /// edgesOfFaces  ascending ids; kept as a reference
  /// before        the meshes without any shorter edges
  SparedNeighbors(const std::vector<std::vector<int>>& edgesOfFaces,
                  const std::vector<FaceMesh>& before);

  /// Takes back what spoiled a face that was good, or softens it if the face that it was meant for
  /// cannot do without. Adds to `changed` the faces concerned; those that asked are given up.
  void spare(const std::vector<FaceMesh>& next, Refinement& refinement,
             std::vector<std::size_t>& changed, const std::function<void(std::size_t)>& giveUp);

 private:
  bool yields(std::size_t culprit, Refinement& refinement);
  /// The face itself and those that share an edge with it.
  std::vector<std::size_t> beside(std::size_t i) const;

  const std::vector<std::vector<int>>& edgesOfFaces_;
  std::vector<bool> wasBad_;
  std::vector<int> softened_;
};

}  // namespace af2::geometry
