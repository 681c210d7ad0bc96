#include "geometry/charts/quadric_surfaces.h"

#include <algorithm>
#include <limits>
#include <numbers>

namespace af2::geometry {

namespace {

/// t with a t^2 + 2 b t + c = 0 at which b + a t, the slope of the quadratic, has the sign `sign`:
/// where the line leaves (or enters) the surface on the side to which the normals point.
std::optional<double> rootWithSlope(double a, double b, double c, double sign) {
  const double discriminant = b * b - a * c;
  if (!(discriminant >= 0)) return std::nullopt;
  const double slope = sign * std::sqrt(discriminant);
  // Two forms of the same root; each cancels where the other does not.
  if (b * slope >= 0) {
    const double sum = b + slope;
    if (sum == 0) return c == 0 ? std::optional(0.0) : std::nullopt;
    return -c / sum;
  }
  if (a == 0) return std::nullopt;
  return (slope - b) / a;
}

Point3 across(const Point3& p, const Point3& axis) { return p - dot(p, axis) * axis; }

/// The tangent for 30 degrees between axis and surface.
constexpr double kSharpTangent = 0.577;

double signOf(Side side) { return side == Side::Outer ? 1.0 : -1.0; }

}  // namespace

CylinderSurface::CylinderSurface(const Point3& onAxis, const Point3& axis, double radius, Side side)
    : onAxis_(onAxis), axis_(axis), radius_(radius), sign_(signOf(side)) {}

Point3 CylinderSurface::normalAt(const Point3& position) const {
  return sign_ * unit(across(position - onAxis_, axis_));
}

std::optional<SurfacePoint> CylinderSurface::hit(const SurfaceLine& line) const {
  const Point3 w = across(line.start - onAxis_, axis_);
  const Point3 m = across(line.direction, axis_);
  const auto t = rootWithSlope(dot(m, m), dot(w, m), dot(w, w) - radius_ * radius_, sign_);
  if (!t) return std::nullopt;
  return SurfacePoint{line.start + *t * line.direction, sign_ * unit(w + *t * m)};
}

SphereSurface::SphereSurface(const Point3& centre, double radius, Side side)
    : centre_(centre), radius_(radius), sign_(signOf(side)) {}

Point3 SphereSurface::normalAt(const Point3& position) const {
  return sign_ * unit(position - centre_);
}

std::optional<SurfacePoint> SphereSurface::hit(const SurfaceLine& line) const {
  const Point3 w = line.start - centre_;
  const auto t = rootWithSlope(1, dot(w, line.direction), dot(w, w) - radius_ * radius_, sign_);
  if (!t) return std::nullopt;
  const Point3 radial = w + *t * line.direction;
  return SurfacePoint{centre_ + radial, sign_ * unit(radial)};
}

ConeSurface::ConeSurface(const Point3& apex, const Point3& axis, double tangent, Side side,
                         double extent)
    : apex_(apex), axis_(axis), tangent_(tangent), sign_(signOf(side)), tipRadius_(1e-9 * extent) {}

Point3 ConeSurface::normalAt(const Point3& position) const {
  const Point3 d = position - apex_;
  const Point3 radial = across(d, axis_);
  if (length(radial) <= tipRadius_) return tangent_ < kSharpTangent ? Point3{} : -sign_ * axis_;
  return sign_ * unit(unit(radial) - tangent_ * axis_);
}

double ConeSurface::curvatureRadiusAt(const Point3& position) const {
  return length(across(position - apex_, axis_)) * std::sqrt(1 + tangent_ * tangent_);
}

double ConeSurface::angleAroundApex() const {
  return 2 * std::numbers::pi * tangent_ / std::sqrt(1 + tangent_ * tangent_);
}

std::optional<SurfacePoint> ConeSurface::hit(const SurfaceLine& line) const {
  // |w across the axis|^2 - (tangent * w along the axis)^2 = 0 along the line.
  const double k = tangent_ * tangent_;
  const Point3 w = line.start - apex_;
  const Point3& m = line.direction;
  const double wAxis = dot(w, axis_), mAxis = dot(m, axis_);
  const double a = 1 - mAxis * mAxis - k * mAxis * mAxis;
  const double b = dot(w, m) - wAxis * mAxis - k * wAxis * mAxis;
  const double c = dot(w, w) - wAxis * wAxis - k * wAxis * wAxis;
  const auto t = rootWithSlope(a, b, c, sign_);
  if (!t || wAxis + *t * mAxis <= 0) return std::nullopt;  // the other nappe
  const Point3 position = line.start + *t * m;
  return SurfacePoint{position, normalAt(position)};
}

TorusSurface::TorusSurface(const Point3& centre, const Point3& axis, double major, double minor,
                           Side side)
    : centre_(centre), axis_(axis), major_(major), minor_(minor), sign_(signOf(side)) {}

Point3 TorusSurface::fromCentreLine(const Point3& position) const {
  const Point3 d = position - centre_;
  return d - major_ * unit(across(d, axis_));
}

Point3 TorusSurface::normalAt(const Point3& position) const {
  return sign_ * unit(fromCentreLine(position));
}

double TorusSurface::radiusAroundAxisAt(const Point3& position) const {
  const double fromAxis = length(across(position - centre_, axis_));
  const double cosine = std::abs(fromAxis - major_) / minor_;
  return cosine > 0 ? fromAxis / cosine : std::numeric_limits<double>::infinity();
}

double TorusSurface::curvatureRadiusAt(const Point3& position) const {
  return std::min(minor_, radiusAroundAxisAt(position));
}

std::optional<SurfacePoint> TorusSurface::hit(const SurfaceLine& line) const {
  // Newton on the distance from the surface, which is smooth away from the centre line.
  constexpr int kMaxSteps = 20;
  constexpr double kTolerance = 1e-13;
  Point3 position = line.start;
  for (int step = 0; step < kMaxSteps; ++step) {
    const Point3 radial = fromCentreLine(position);
    const double distance = length(radial);
    const Point3 normal = (sign_ / distance) * radial;
    const double gap = sign_ * (distance - minor_);
    if (std::abs(gap) <= kTolerance * (major_ + minor_)) return SurfacePoint{position, normal};
    const double slope = dot(normal, line.direction);
    if (!(slope > 0)) return std::nullopt;
    position = position - (gap / slope) * line.direction;
  }
  return std::nullopt;
}

}  // namespace af2::geometry
