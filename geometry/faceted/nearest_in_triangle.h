// The point of a triangle that is nearest to another point. Not installed.
#pragma once

#include "engine/base/point.h"
#include "geometry/faceted/facet_layout.h"

namespace af2::geometry {

/// The point of a triangle that is nearest to p: by the region of the plane in which p lies.
inline Barycentric nearestIn(const Point3& p, const Point3& a, const Point3& b, const Point3& c) {
  const Point3 ab = b - a, ac = c - a, ap = p - a, bp = p - b, cp = p - c;
  const double d1 = dot(ab, ap), d2 = dot(ac, ap), d3 = dot(ab, bp), d4 = dot(ac, bp),
               d5 = dot(ab, cp), d6 = dot(ac, cp);
  if (d1 <= 0 && d2 <= 0) return {1, 0, 0};
  if (d3 >= 0 && d4 <= d3) return {0, 1, 0};
  if (d6 >= 0 && d5 <= d6) return {0, 0, 1};
  const double va = d3 * d6 - d5 * d4, vb = d5 * d2 - d1 * d6, vc = d1 * d4 - d3 * d2;
  if (vc <= 0 && d1 >= 0 && d3 <= 0) return {1 - d1 / (d1 - d3), d1 / (d1 - d3), 0};
  if (vb <= 0 && d2 >= 0 && d6 <= 0) return {1 - d2 / (d2 - d6), 0, d2 / (d2 - d6)};
  if (va <= 0 && d4 >= d3 && d5 >= d6) {
    const double t = (d4 - d3) / (d4 - d3 + d5 - d6);
    return {0, 1 - t, t};
  }
  const double sum = va + vb + vc;
  if (sum == 0) return {1, 0, 0};
  return {va / sum, vb / sum, vc / sum};
}

}  // namespace af2::geometry
