// A row of the list of edges of a model, by which a user can identify an edge.
#pragma once

#include <string>
#include <vector>

#include "engine/base/point.h"

namespace af2::geometry {

struct EdgeEntry {
  int id = 0;
  std::string curve;  ///< "line", "circle", "bspline", ...
  double length = 0;
  Point3 from, to;
  std::vector<int> faces;  ///< ascending
};

}  // namespace af2::geometry
