// Finds the parameters of given points that divide an edge.
// Not installed.
#pragma once

#include <functional>
#include <limits>
#include <vector>

#include "engine/base/point.h"

namespace af2::geometry {

/// The nearest place on a curve.
struct CurveFoot {
  double parameter = 0;
  double distance = std::numeric_limits<double>::infinity();  ///< infinite: none between the ends
};

struct PlacedPoints {
  std::vector<Point3> points;      ///< the given points, in the direction of the edge
  std::vector<double> parameters;  ///< of the points, and of the ends of the edge around them
};

/// An edge, or a part of it.
struct PlacedRange {
  double first = 0, last = 0;  ///< parameters of its ends
  double tolerance = 0;        ///< how far from it points may be
};

/// The distance that points which divide an edge of this length may have from it: a hundredth of a
/// segment.
double toleranceOfPoints(double length, std::size_t points);

/// Finds the parameters of points between the ends of an edge.
///
/// edge  its id, for messages
///
/// Throws InputError unless they are on it, in order and distinct.
PlacedPoints placePoints(int edge, std::vector<Point3> points, const PlacedRange& range,
                         const std::function<CurveFoot(const Point3&)>& footOf);

/// Throws InputError if points divide an edge into fewer segments than it needs.
void requireSegments(int edge, std::size_t points, std::size_t least);

}  // namespace af2::geometry
