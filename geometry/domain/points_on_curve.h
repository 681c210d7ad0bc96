// Points from outside that divide a curve of a domain.
// Not installed.
#pragma once

#include <vector>

#include "geometry/domain/domain_model.h"
#include "geometry/edges/placed_points.h"

namespace af2::geometry {

/// From knot to knot.
double lengthOf(const DomainCurve& curve);

/// Finds where the points between the ends of a curve lie on it.
///
/// least  segments that the curve needs
///
/// Throws InputError unless they do, in order and apart, to a hundredth of a segment.
PlacedPoints placeOnCurve(const DomainCurve& curve, const std::vector<Point3>& points,
                          std::size_t least);

}  // namespace af2::geometry
