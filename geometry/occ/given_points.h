// Points from outside that divide an edge.
// Not installed: includers need OpenCASCADE's headers.
#pragma once

#include <vector>

#include "engine/point.h"
#include "geometry/occ/model_shape.h"

namespace af2::geometry {

struct GivenPoints {
  std::vector<Point3> points;      ///< as they were given, in the direction of the edge
  std::vector<double> parameters;  ///< of the points, and of the ends of the edge around them
};

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
GivenPoints placeOnEdge(const ModelShape& model, int edge, std::vector<Point3> points,
                        const EdgeRange& range);

}  // namespace af2::geometry
