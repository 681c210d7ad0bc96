// Distances to segments in a chart.
// Not installed.
#pragma once

#include <algorithm>

#include "engine/base/point.h"

namespace af2 {

inline double distanceToSegment(Point2 p, Point2 from, Point2 to) {
  const Point2 edge = to - from;
  const double squared = dot(edge, edge);
  const double t = squared > 0 ? std::clamp(dot(p - from, edge) / squared, 0.0, 1.0) : 0.0;
  return distance(p, from + t * edge);
}

}  // namespace af2
