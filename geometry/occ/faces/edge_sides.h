// In which direction faces run along edges.
// Not installed: includers need OpenCASCADE's headers.
#pragma once

#include <map>
#include <vector>

#include "geometry/occ/model/model_shape.h"

namespace af2::geometry {

/// How a face runs along an edge, seen from outside.
struct EdgeSide {
  int face = 0;
  bool isForward = true;
};

/// By edge of the file that is no point: one for each time that a face has it. Two faces that meet
/// there run along it in opposite directions, unless one of them is turned.
std::map<int, std::vector<EdgeSide>> sidesOfEdges(const ModelShape& model);

}  // namespace af2::geometry
