// Finds ends of edges at which the boundary of a face has a gap.
// Not installed: includers need OpenCASCADE's headers.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "engine/base/point.h"
#include "geometry/occ/model/model_shape.h"

namespace af2::geometry {

/// Ends of an edge: indices of points.
struct Ends {
  std::uint32_t first = 0, last = 0;
};

/// Pairs of points to be merged, so that the wires of the faces close: at one of them a wire ends,
/// at the other it continues, and their distance is within the tolerances of the model.
///
/// ends       by edge; [0] is edge 1
/// tolerance  by point
std::vector<std::pair<std::uint32_t, std::uint32_t>> gapsInWires(
    const ModelShape& model, const std::vector<Ends>& ends, const std::vector<bool>& isUsed,
    const std::vector<Point3>& points, const std::vector<double>& tolerance);

}  // namespace af2::geometry
