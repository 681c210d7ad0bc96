// Places given points on the edge of a CAD model that they divide.
// Not installed: includers need OpenCASCADE's headers.
#pragma once

#include <vector>

#include "geometry/edges/placed_points.h"
#include "geometry/occ/model/model_shape.h"

namespace af2::geometry {

/// A part of an edge, or the whole edge.
struct EdgeRange {
  double first = 0, last = 0;  ///< parameters
  double length = 0;
  double tolerance = 0;  ///< distance that points may have from it in any case
};

/// Finds the parameters of points between the ends of an edge, or of a part of it.
///
/// Throws InputError unless they are on it, in order and distinct, within the largest of the
/// tolerance of the edge, a hundredth of the adjacent segments, and the tolerance of the range.
PlacedPoints placeOnEdge(const ModelShape& model, int edge, const std::vector<Point3>& points,
                         const EdgeRange& range);

}  // namespace af2::geometry
