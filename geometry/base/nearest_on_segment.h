// The nearest point of a segment in space.
// Not installed.
#pragma once

#include <algorithm>

#include "engine/base/point.h"

namespace af2::geometry {

/// The ends must be apart.
inline Point3 nearestOnSegment(const Point3& p, const Point3& a, const Point3& b) {
  const Point3 d = b - a;
  const double t = std::clamp(dot(p - a, d) / dot(d, d), 0.0, 1.0);
  return a + t * d;
}

}  // namespace af2::geometry
