// Points from outside that divide an edge of a CAD model.
// Not installed: includers need OpenCASCADE's headers.
#pragma once

#include <vector>

#include "geometry/edges/placed_points.h"
#include "geometry/occ/model/model_shape.h"

namespace af2::geometry {

/// A part of an edge, or all of it.
struct EdgeRange {
  double first = 0, last = 0;  ///< parameters
  double length = 0;
  double tolerance = 0;  ///< how far from it points may lie, whatever else is said
};

/// Finds where the points between the ends of an edge, or of a part of it, lie on its curve.
///
/// Throws InputError unless they lie on it, in order and apart: within the tolerance of the edge, a
/// hundredth of the segments beside them, or the tolerance of the range.
PlacedPoints placeOnEdge(const ModelShape& model, int edge, const std::vector<Point3>& points,
                         const EdgeRange& range);

}  // namespace af2::geometry
