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

/// Whether two segments cross, where rounding does not matter.
inline bool doCross(Point2 a, Point2 b, Point2 c, Point2 d) {
  const auto side = [](Point2 p, Point2 q, Point2 r) { return cross(q - p, r - p) > 0; };
  return side(a, b, c) != side(a, b, d) && side(c, d, a) != side(c, d, b);
}

/// Whether two segments come closer than a limit. Compares their boxes first: most are far away.
inline bool areCloser(double limit, Point2 a, Point2 b, Point2 c, Point2 d) {
  if (std::max(a.x, b.x) + limit < std::min(c.x, d.x) ||
      std::max(c.x, d.x) + limit < std::min(a.x, b.x) ||
      std::max(a.y, b.y) + limit < std::min(c.y, d.y) ||
      std::max(c.y, d.y) + limit < std::min(a.y, b.y))
    return false;
  return distanceToSegment(a, c, d) < limit || distanceToSegment(b, c, d) < limit ||
         distanceToSegment(c, a, b) < limit || distanceToSegment(d, a, b) < limit ||
         doCross(a, b, c, d);
}

}  // namespace af2
