// Divisions of model edges that the caller gives.
#pragma once

#include <map>
#include <vector>

#include "engine/base/point.h"

namespace af2::geometry {

/// By id of the edge: the vertices between its ends, in order along the edge, one way or the other.
using EdgePoints = std::map<int, std::vector<Point3>>;

}  // namespace af2::geometry
