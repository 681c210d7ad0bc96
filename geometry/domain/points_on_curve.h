// Places given points on the curve of a domain that they divide.
// Not installed.
#pragma once

#include <vector>

#include "geometry/domain/domain_model.h"
#include "geometry/edges/placed_points.h"

namespace af2::geometry {

/// The length of the polyline through the knots.
double lengthOf(const DomainCurve& curve);

/// The point of a curve that is nearest to another.
CurveFoot footOn(const DomainCurve& curve, const Point3& point);

/// Finds the parameters of the points between the ends of a curve.
///
/// least  segments that the curve needs
///
/// Throws InputError unless the points are on the curve, to a hundredth of a segment, in order and
/// distinct.
PlacedPoints placeOnCurve(const DomainCurve& curve, const std::vector<Point3>& points,
                          std::size_t least);

}  // namespace af2::geometry
