// A torus laid out in the plane: conformal, in closed form.
#pragma once

#include "geometry/charts/plane_map.h"
#include "geometry/charts/unrolled_surfaces.h"

namespace af2::geometry {

/// x is proportional to the angle around the axis; y is proportional to the integral of ds / r
/// along a meridian, with s the length and r the distance from the axis. Both are lengths where r
/// is the major radius.
class TorusMap final : public PlaneMap {
 public:
  /// frame    its origin is the centre
  /// surface  the same torus, which does not intersect itself
  TorusMap(const AxisFrame& frame, const TorusSurface& surface);

  /// The parameters only select the turn: u around the axis, v around the centre line.
  Point2 flatten(const SurfacePoint& point) const override;
  SurfacePoint lift(Point2 place) const override;
  double scaleAt(Point2 place) const override;
  Point2 scaleGradientAt(Point2 place) const override;

 private:
  /// (cos v, sin v) at a height of the plane.
  Point2 acrossAt(double y) const;

  AxisFrame frame_;
  double major_, minor_;
  double stretch_;   ///< tan(half of the stretched angle) = stretch * tan(v / 2)
  double perAngle_;  ///< change of y per unit of the stretched angle
  double side_, sense_;
};

}  // namespace af2::geometry
