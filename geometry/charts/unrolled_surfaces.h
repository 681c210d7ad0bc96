// Cylinder and cone unrolled into the plane: isometries, in closed form.
#pragma once

#include "engine/base/elementary.h"
#include "geometry/base/turns.h"
#include "geometry/charts/metric_chart.h"
#include "geometry/charts/plane_map.h"
#include "geometry/charts/quadric_surfaces.h"

namespace af2::geometry {

/// Three perpendicular unit vectors, the third of which is the axis; left-handed or right-handed.
struct AxisFrame {
  Point3 origin, x, y, axis;
  /// The direction perpendicular to the axis at an angle from x.
  Point3 radial(double angle) const;
  /// The angle of a point around the axis, on the turn nearest to `near`.
  double angleNear(const Point3& position, double near) const;
};

/// Its parameters are lengths on the surface.
class UnrolledSurface : public ParametricSurface {
 public:
  /// position  of a point, on the surface or nearly so
  /// u, v      its angle around the axis and its height, about: they select the turn
  virtual Point2 develop(const Point3& position, double u, double v) const = 0;
};

class UnrolledCylinder final : public UnrolledSurface {
 public:
  /// surface  the same cylinder, for its normals
  UnrolledCylinder(const AxisFrame& frame, const CylinderSurface& surface);
  Point2 develop(const Point3& position, double u, double v) const override;
  Frame frameAt(double x, double y) const override;
  SurfacePoint pointAt(double x, double y) const override;
  bool isFlipped() const override { return isFlipped_; }

 private:
  AxisFrame frame_;
  double radius_, side_;
  bool isFlipped_;
};

/// One nappe; its tip is an ordinary point.
class UnrolledCone final : public UnrolledSurface {
 public:
  /// frame      its origin is the apex
  /// halfAngle  between the axis and the nappe
  /// middle     angle around the axis that is mapped to the x axis: the middle of the face, so that
  ///            a whole turn fits
  /// surface    the same nappe, for its normals
  UnrolledCone(const AxisFrame& frame, double halfAngle, double middle, const ConeSurface& surface);
  Point2 develop(const Point3& position, double u, double v) const override;
  Frame frameAt(double x, double y) const override;
  SurfacePoint pointAt(double x, double y) const override;
  bool isFlipped() const override { return isFlipped_; }

 private:
  /// The ruling through a point of the plane: its angle around the axis.
  double angleAt(double x, double y) const { return middle_ + angleOf({x, y}) / sine_; }

  Point3 ruling(const Point3& radial) const { return sine_ * radial + cosine_ * frame_.axis; }

  AxisFrame frame_;
  double sine_, cosine_, middle_;
  ConeSurface surface_;
  bool isFlipped_ = false;
};

/// The plane of a surface whose parameters are lengths.
class UnrolledMap final : public PlaneMap {
 public:
  /// surface  is kept as a reference
  explicit UnrolledMap(const UnrolledSurface& surface)
      : surface_(surface), sense_(surface.isFlipped() ? -1 : 1) {}
  Point2 flatten(const SurfacePoint& point) const override { return {sense_ * point.u, point.v}; }
  SurfacePoint lift(Point2 place) const override {
    return surface_.pointAt(sense_ * place.x, place.y);
  }

 private:
  const UnrolledSurface& surface_;
  double sense_;
};

}  // namespace af2::geometry
