// A torus laid out in the plane: conformal, in closed form.
#pragma once

#include "geometry/charts/plane_map.h"
#include "geometry/charts/unrolled_surfaces.h"

namespace af2::geometry {

/// x goes with the angle around the axis, y with the integral of the length along a meridian over
/// the distance from the axis; both are lengths where that distance is the major radius.
class TorusMap final : public PlaneMap {
 public:
  /// frame    its origin is the centre
  /// surface  the same torus, which does not meet itself
  TorusMap(const AxisFrame& frame, const TorusSurface& surface);

  /// The parameters tell the turns only: u around the axis, v around the centre line.
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
  double perAngle_;  ///< y for one of the stretched angle
  double side_, sense_;
};

}  // namespace af2::geometry
