// Faces that may be congruent, as far as numbers tell that are known before any of them is meshed.
// Not installed.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "geometry/edges/divided_edges.h"

namespace af2::geometry {

/// What congruent faces have in common.
struct FaceNumbers {
  std::size_t face = 0;  ///< in any numbering
  std::string surfaceType;
  std::vector<std::size_t> segments;  ///< of its edges, ascending
  double area = 0;                    ///< 0: unknown
};

/// Groups of faces that may be congruent, each ascending, in the order of their first faces. Faces
/// of unknown area are alone.
std::vector<std::vector<std::size_t>> similarFaces(std::vector<FaceNumbers> faces);

}  // namespace af2::geometry
