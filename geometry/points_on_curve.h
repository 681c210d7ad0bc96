// Points from outside that divide a curve of a domain.
// Not installed.
#pragma once

#include <vector>

#include "geometry/domain_model.h"

namespace af2::geometry {

struct PlacedPoints {
  std::vector<Point3> points;      ///< as they were given, in the direction of the curve
  std::vector<double> parameters;  ///< of the points
};

/// Finds where the points between the ends of a curve lie on it.
///
/// least  segments that the curve needs
///
/// Throws InputError unless they lie on it, in order and apart, to a hundredth of a segment.
PlacedPoints placeOnCurve(const DomainCurve& curve, std::vector<Point3> points, std::size_t least);

}  // namespace af2::geometry
