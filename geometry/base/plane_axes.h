// Two axes perpendicular to a normal.
#pragma once

#include <cmath>

#include "engine/base/point.h"

namespace af2::geometry {

/// Coordinates in the plane through a point, perpendicular to a normal. They are counter-clockwise
/// as seen from the side to which the normal points.
class PlaneAxes {
 public:
  explicit PlaneAxes(const SurfacePoint& at) : PlaneAxes(at.position, at.normal) {}
  PlaneAxes(const Point3& origin, const Point3& normal) : origin_(origin) {
    const double x = std::abs(normal.x), y = std::abs(normal.y), z = std::abs(normal.z);
    // Any direction perpendicular to the normal will do; this one comes from the coordinate axis
    // that is least parallel to it.
    const Point3 axis = x <= y && x <= z ? Point3{1, 0, 0}
                        : y <= z         ? Point3{0, 1, 0}
                                         : Point3{0, 0, 1};
    x_ = unit(cross(axis, normal));
    y_ = cross(normal, x_);
  }

  Point2 operator()(const SurfacePoint& point) const { return (*this)(point.position); }
  Point2 operator()(const Point3& point) const {
    const Point3 d = point - origin_;
    return {dot(d, x_), dot(d, y_)};
  }
  const Point3& xAxis() const { return x_; }
  const Point3& yAxis() const { return y_; }

 private:
  Point3 origin_, x_, y_;
};

}  // namespace af2::geometry
