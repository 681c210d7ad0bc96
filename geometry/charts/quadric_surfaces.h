// Cylinder, cone, sphere and torus in closed form: where a line along a chart's normal meets them.
// They store no parameters (u, v), because meshing does not need them and each costs an arc
// tangent.
#pragma once

#include "engine/base/export.h"
#include "engine/surface/local_transform.h"
#include "geometry/charts/mean_normal_chart.h"

namespace af2::geometry {

/// Which side of a surface the normals of a face point to: away from the axis, centre or centre
/// line, or towards it.
enum class Side { Outer = 1, Inner = -1 };

class AF2_EXPORT CylinderSurface {
 public:
  /// axis  of unit length
  CylinderSurface(const Point3& onAxis, const Point3& axis, double radius, Side side);
  std::optional<SurfacePoint> hit(const SurfaceLine& line) const;
  Point3 normalAt(const Point3& position) const;
  double radius() const { return radius_; }

 private:
  Point3 onAxis_, axis_;
  double radius_, sign_;
};

class AF2_EXPORT SphereSurface {
 public:
  SphereSurface(const Point3& centre, double radius, Side side);
  std::optional<SurfacePoint> hit(const SurfaceLine& line) const;
  Point3 normalAt(const Point3& position) const;
  const Point3& centre() const { return centre_; }
  Side side() const { return sign_ > 0 ? Side::Outer : Side::Inner; }
  double radius() const { return radius_; }

 private:
  Point3 centre_;
  double radius_, sign_;
};

/// One nappe of a cone.
class AF2_EXPORT ConeSurface {
 public:
  /// axis     of unit length, from the apex to where the nappe widens
  /// tangent  of the angle between axis and surface, > 0
  /// extent   approximate size of the face: nearer to the apex than a billionth of it is the apex
  ConeSurface(const Point3& apex, const Point3& axis, double tangent, Side side, double extent = 1);
  std::optional<SurfacePoint> hit(const SurfaceLine& line) const;
  /// At the apex this is the mean of the normals around it, which is along the axis. It is zero if
  /// the cone is so sharp that elements around the apex tilt too far against that mean.
  Point3 normalAt(const Point3& position) const;
  /// Smaller radius of curvature.
  double curvatureRadiusAt(const Point3& position) const;
  /// The same, at a distance from the apex along the surface.
  double curvatureRadiusAtDistance(double distance) const { return distance * tangent_; }
  const Point3& apex() const { return apex_; }
  /// The angle of the unrolled nappe at its apex.
  double angleAroundApex() const;

 private:
  Point3 apex_, axis_;
  double tangent_, sign_, tipRadius_;
};

class AF2_EXPORT TorusSurface {
 public:
  /// axis  of unit length
  /// major, minor  radii of the centre line and around it; the spindle torus (minor > major) counts
  ///               with its outer part only
  TorusSurface(const Point3& centre, const Point3& axis, double major, double minor, Side side);
  std::optional<SurfacePoint> hit(const SurfaceLine& line) const;
  Point3 normalAt(const Point3& position) const;
  double major() const { return major_; }
  double minor() const { return minor_; }
  /// Smaller radius of curvature.
  double curvatureRadiusAt(const Point3& position) const;
  /// The radius of curvature along the circles around the axis.
  double radiusAroundAxisAt(const Point3& position) const;

 private:
  /// The vector from the nearest point of the centre line to a position.
  Point3 fromCentreLine(const Point3& position) const;

  Point3 centre_, axis_;
  double major_, minor_, sign_;
};

}  // namespace af2::geometry
