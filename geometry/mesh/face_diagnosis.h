// Where the mesh of a face is missing or poor, and how far from acceptable it is.
#pragma once

#include <vector>

#include "geometry/sizes/graded_size.h"

namespace af2::geometry {

/// Places that want shorter edges, and how far from acceptable a mesh is: 0 is good enough.
struct FaceDiagnosis {
  std::vector<SizeSource> places;
  double poorness = 0;
  bool isBad = false;         ///< not fit for use; else it could be nicer, but not at any price
  bool hasBadAngle = false;   ///< one that makes an element hardly of use
  bool hasWrongArea = false;  ///< no check would let the mesh pass
};

}  // namespace af2::geometry
