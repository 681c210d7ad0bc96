// Finds faces that overlap: a model that folds back on itself, or has a face twice.
// Not installed: includers need OpenCASCADE's headers.
#pragma once

#include <vector>

#include "geometry/occ/model/model_shape.h"

namespace af2::geometry {

/// A face that is entirely on another one, with which it shares edges.
struct FaceOnFace {
  int face = 0, under = 0;
  /// Edges at which the one face folds back onto the other; no third face has them. Empty: the
  /// other face has all edges of this one, so it is the same face again.
  std::vector<int> folds;

  bool isDouble() const { return folds.empty(); }
};

/// In the order of the faces. A face that is on another one is not listed as the lower face of a
/// third one.
std::vector<FaceOnFace> facesOnFaces(const ModelShape& model, int threads);

}  // namespace af2::geometry
