// Says that the model is why a face failed.
// Not installed.
#pragma once

#include <string>

#include "geometry/mesh/model_mesh.h"

namespace af2::geometry {

/// Adds a fault of the model to the reason why a face failed.
inline void blameModel(const std::string& fault, FaceReport& face) {
  face.reason += "; " + fault;
  face.cause = FailureCause::Model;
}

}  // namespace af2::geometry
