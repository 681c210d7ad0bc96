// The result of a diagnosis: where the mesh of a face is missing or poor, and by how much.
#pragma once

#include <vector>

#include "geometry/sizes/graded_size.h"

namespace af2::geometry {

/// Places that need shorter edges, and how far from acceptable a mesh is: 0 is good enough.
struct FaceDiagnosis {
  std::vector<SizeSource> places;
  double poorness = 0;
  bool isBad = false;         ///< true: not usable; false: it could be better, but not at any cost
  bool hasBadAngle = false;   ///< an angle that makes an element hardly usable
  bool hasWrongArea = false;  ///< so wrong that no check would accept it
};

}  // namespace af2::geometry
