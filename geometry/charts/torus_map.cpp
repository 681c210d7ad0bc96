#include "geometry/charts/torus_map.h"

#include <cmath>

#include "engine/base/elementary.h"

namespace af2::geometry {

TorusMap::TorusMap(const AxisFrame& frame, const TorusSurface& surface)
    : frame_(frame),
      major_(surface.major()),
      minor_(surface.minor()),
      stretch_(std::sqrt((major_ - minor_) / (major_ + minor_))),
      perAngle_(major_ * minor_ / std::sqrt(major_ * major_ - minor_ * minor_)) {
  const Point3 outermost = frame.origin + (major_ + minor_) * frame.x;
  side_ = dot(surface.normalAt(outermost), frame.x) > 0 ? 1 : -1;
  sense_ = side_ * dot(cross(frame.y, frame.axis), frame.x) > 0 ? 1 : -1;
}

Point2 TorusMap::flatten(const SurfacePoint& point) const {
  const double u = frame_.angleNear(point.position, point.u);
  const Point3 d = point.position - frame_.origin;
  const double around = length(Point2{dot(d, frame_.x), dot(d, frame_.y)});
  const double v = angleOf({around - major_, dot(d, frame_.axis)});
  // tan(v / 2) as a direction, which has no pole on the innermost circle.
  const Point2 half = directionAt(0.5 * v);
  const double turns = turnsTowards(v, point.v);
  const double angle = 2 * (angleOf({half.x, stretch_ * half.y}) + kPi * turns);
  return {sense_ * major_ * u, perAngle_ * angle};
}

Point2 TorusMap::acrossAt(double y) const {
  const Point2 half = directionAt(0.5 * y / perAngle_);
  const double c = stretch_ * half.x, s = half.y;  // along (cos, sin) of v / 2
  const double size = c * c + s * s;
  return {(c * c - s * s) / size, 2 * c * s / size};
}

SurfacePoint TorusMap::lift(Point2 place) const {
  const double u = sense_ * place.x / major_;
  const Point2 across = acrossAt(place.y);
  const Point3 radial = frame_.radial(u);
  const Point3 outwards = across.x * radial + across.y * frame_.axis;
  const double angle = angleOf(across);
  // Full turns of the stretched angle and of the angle itself are the same.
  const double turns = turnsTowards(angle, place.y / perAngle_);
  return {frame_.origin + major_ * radial + minor_ * outwards, side_ * outwards, u,
          angle + 2 * kPi * turns};
}

double TorusMap::scaleAt(Point2 place) const {
  return major_ / (major_ + minor_ * acrossAt(place.y).x);
}

Point2 TorusMap::scaleGradientAt(Point2 place) const {
  // The distance r from the axis changes by -sin v along a meridian, which in the plane is r / a
  // times as long.
  return {0, acrossAt(place.y).y / major_};
}

}  // namespace af2::geometry
