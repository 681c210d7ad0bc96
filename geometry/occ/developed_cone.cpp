#include "geometry/occ/developed_cone.h"

#include <cmath>

#include "geometry/occ/points.h"

namespace af2::geometry {

DevelopedCone::DevelopedCone(const gp_Cone& cone, const GeneralSurface& surface, double middleU,
                             double v)
    : surface_(surface),
      apex_(toPoint(cone.Apex())),
      middleU_(middleU),
      sine_(std::abs(std::sin(cone.SemiAngle()))),
      apexV_(-cone.RefRadius() / std::sin(cone.SemiAngle())),
      sense_(v > apexV_ ? 1 : -1),
      unitV_(apexV_ + sense_) {
  const Frame frame = frameAt(1, 0);
  isFlipped_ = dot(cross(frame.du, frame.dv), surface_.normalAt(middleU_, unitV_)) < 0;
}

Point2 DevelopedCone::develop(double u, double v) const {
  const double fromTip = sense_ * (v - apexV_);
  const double angle = (u - middleU_) * sine_;
  return {fromTip * std::cos(angle), fromTip * std::sin(angle)};
}

double DevelopedCone::angleAt(double x, double y) const {
  return middleU_ + (x == 0 && y == 0 ? 0 : std::atan2(y, x) / sine_);
}

ParametricSurface::Frame DevelopedCone::frameAt(double x, double y) const {
  const double fromTip = std::hypot(x, y);
  const Frame frame = surface_.frameAt(angleAt(x, y), unitV_);
  const Point3 outwards = sense_ * unit(frame.dv), around = unit(frame.du);
  const double cosine = fromTip > 0 ? x / fromTip : 1, sine = fromTip > 0 ? y / fromTip : 0;
  return {apex_ + fromTip * outwards, cosine * outwards - sine * around,
          sine * outwards + cosine * around};
}

SurfacePoint DevelopedCone::pointAt(double x, double y) const {
  return {frameAt(x, y).position, surface_.normalAt(angleAt(x, y), unitV_), x, y};
}

}  // namespace af2::geometry
