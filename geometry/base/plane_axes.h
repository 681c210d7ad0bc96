// Two axes across a normal.
#pragma once

#include <cmath>

#include "engine/base/point.h"

namespace af2::geometry {

/// Coordinates in the plane through a point, across its normal: counter-clockwise seen from where
/// the normal points to.
class PlaneAxes {
 public:
  explicit PlaneAxes(const SurfacePoint& at) : PlaneAxes(at.position, at.normal) {}
  PlaneAxes(const Point3& origin, const Point3& normal) : origin_(origin) {
    const double x = std::abs(normal.x), y = std::abs(normal.y), z = std::abs(normal.z);
    // Any direction across the normal will do, e.g. from the coordinate axis farthest from it.
    const Point3 axis = x <= y && x <= z ? Point3{1, 0, 0}
                        : y <= z         ? Point3{0, 1, 0}
                                         : Point3{0, 0, 1};
    x_ = unit(cross(axis, normal));
    y_ = cross(normal, x_);
  }

  Point2 operator()(const SurfacePoint& point) const {
    const Point3 d = point.position - origin_;
    return {dot(d, x_), dot(d, y_)};
  }
  const Point3& xAxis() const { return x_; }
  const Point3& yAxis() const { return y_; }

 private:
  Point3 origin_, x_, y_;
};

}  // namespace af2::geometry
