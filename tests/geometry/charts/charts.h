// Base edges for tests of charts.
#pragma once

#include "engine/surface/local_transform.h"
#include "geometry/charts/unrolled_surfaces.h"

namespace af2::testing {

/// The base edge of a chart with a given origin, x axis and normal.
struct BaseEdge {
  SurfacePoint from, to;
  BaseEdge(const Point3& origin, const Point3& along, const Point3& normal)
      : from{origin, normal}, to{origin + along, normal} {}
};

/// Two axis frames off the origin, one of them left-handed.
inline const geometry::AxisFrame kFrame{{1, 2, 3}, {0, 1, 0}, {0, 0, 1}, {1, 0, 0}};
inline const geometry::AxisFrame kLeftHanded{{1, 2, 3}, {0, 0, 1}, {0, 1, 0}, {1, 0, 0}};

/// Sum of the distances of the coordinates.
inline double gap(const Point3& p, const Point3& q) {
  return std::abs(p.x - q.x) + std::abs(p.y - q.y) + std::abs(p.z - q.z);
}
inline double gap(Point2 p, Point2 q) { return std::abs(p.x - q.x) + std::abs(p.y - q.y); }

}  // namespace af2::testing
