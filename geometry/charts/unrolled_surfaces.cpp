#include "geometry/charts/unrolled_surfaces.h"

#include <cmath>

#include "engine/base/elementary.h"

namespace af2::geometry {

Point3 AxisFrame::radial(double angle) const {
  const Point2 direction = directionAt(angle);
  return direction.x * x + direction.y * y;
}

double AxisFrame::angleNear(const Point3& position, double near) const {
  const Point3 d = position - origin;
  const double angle = angleOf({dot(d, x), dot(d, y)});
  return angle + 2 * kPi * turnsTowards(angle, near);
}

UnrolledCylinder::UnrolledCylinder(const AxisFrame& frame, const CylinderSurface& surface)
    : frame_(frame), radius_(surface.radius()) {
  const Point3 outwards = frame.radial(0);
  side_ = dot(surface.normalAt(frame.origin + radius_ * outwards), outwards) > 0 ? 1 : -1;
  isFlipped_ = side_ * dot(cross(frame.y, frame.axis), frame.x) < 0;
}

Point2 UnrolledCylinder::develop(const Point3& position, double u, double) const {
  return {radius_ * frame_.angleNear(position, u), dot(position - frame_.origin, frame_.axis)};
}

ParametricSurface::Frame UnrolledCylinder::frameAt(double x, double y) const {
  const Point2 direction = directionAt(x / radius_);
  const Point3 radial = direction.x * frame_.x + direction.y * frame_.y;
  return {frame_.origin + radius_ * radial + y * frame_.axis,
          direction.x * frame_.y - direction.y * frame_.x, frame_.axis};
}

SurfacePoint UnrolledCylinder::pointAt(double x, double y) const {
  const Point3 radial = frame_.radial(x / radius_);
  return {frame_.origin + radius_ * radial + y * frame_.axis, side_ * radial, x, y};
}

UnrolledCone::UnrolledCone(const AxisFrame& frame, double halfAngle, double middle,
                           const ConeSurface& surface)
    : frame_(frame),
      sine_(directionAt(halfAngle).y),
      cosine_(directionAt(halfAngle).x),
      middle_(middle),
      surface_(surface) {
  const Frame there = frameAt(1, 0);
  isFlipped_ = dot(cross(there.du, there.dv), surface.normalAt(there.position)) < 0;
}

Point2 UnrolledCone::develop(const Point3& position, double u, double) const {
  // Near the tip only the parameter knows the angle.
  const Point3 d = position - frame_.origin;
  const double around = length(Point2{dot(d, frame_.x), dot(d, frame_.y)});
  const double along = dot(d, frame_.axis);
  const double angle = around > 1e-6 * std::abs(along) * sine_ ? frame_.angleNear(position, u) : u;
  return (sine_ * around + cosine_ * along) * directionAt((angle - middle_) * sine_);
}

ParametricSurface::Frame UnrolledCone::frameAt(double x, double y) const {
  const double fromTip = std::sqrt(x * x + y * y);
  const Point2 direction = directionAt(angleAt(x, y));
  const Point3 outwards = ruling(direction.x * frame_.x + direction.y * frame_.y);
  const Point3 around = direction.x * frame_.y - direction.y * frame_.x;
  const double cosine = fromTip > 0 ? x / fromTip : 1, sine = fromTip > 0 ? y / fromTip : 0;
  return {frame_.origin + fromTip * outwards, cosine * outwards - sine * around,
          sine * outwards + cosine * around};
}

SurfacePoint UnrolledCone::pointAt(double x, double y) const {
  const double fromTip = std::sqrt(x * x + y * y);
  const Point3 position = frame_.origin + fromTip * ruling(frame_.radial(angleAt(x, y)));
  return {position, surface_.normalAt(position), x, y};
}

}  // namespace af2::geometry
