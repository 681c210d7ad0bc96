// Faces that lie on each other: a model that folds back on itself, or has a face twice.
// Not installed: includers need OpenCASCADE's headers.
#pragma once

#include <vector>

#include "geometry/occ/model/model_shape.h"

namespace af2::geometry {

/// A face that lies wholly on another one, with which it has edges in common.
struct FaceOnFace {
  int face = 0, under = 0;
  /// Edges at which the one turns back onto the other; no other face has them. Empty: the face has
  /// no edge that the other one has not, so it is the same face once more.
  std::vector<int> folds;

  bool isDouble() const { return folds.empty(); }
};

/// In the order of the faces. No face lies on one that lies on another one itself.
std::vector<FaceOnFace> facesOnFaces(const ModelShape& model, int threads);

}  // namespace af2::geometry
