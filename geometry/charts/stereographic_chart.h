// Stereographic charts of spheres: conformal, without poles or seams, in closed form.
#pragma once

#include "engine/base/export.h"
#include "engine/surface/local_transform.h"
#include "geometry/charts/quadric_surfaces.h"

namespace af2::geometry {

/// Stereographic projection onto the plane through the base edge, from the point of the sphere
/// opposite the middle of the base edge. Angles are kept; lengths grow away from the base edge, by
/// 7 % at 30 degrees. Every point of the sphere except the opposite one has a place.
class AF2_EXPORT StereographicChart final : public AF2LocalTransform {
 public:
  /// Throws GeometryError if `from` and `to` are opposite points of the sphere.
  StereographicChart(const SphereSurface& sphere, const SurfacePoint& from, const SurfacePoint& to,
                     double edgeLength);

  ChartPoint transformFromSurface(const SurfacePoint& point) const override {
    return frame_.project(point);
  }
  std::optional<SurfacePoint> transformToSurface(Point2 point) const override;
  const ProjectionFrame* projection() const override { return &frame_; }

 private:
  ProjectionFrame frame_;
  Point3 sphereCentre_, up_;  ///< up: from the centre of the sphere towards the plane
  double radius_, side_;
  double height_, middle_, edgeLength_;  ///< of the plane over the opposite point; half the chord
};

class StereographicChartMaker final : public ChartMaker<StereographicChartMaker> {
 public:
  explicit StereographicChartMaker(const SphereSurface& sphere) : sphere_(sphere) {}

  StereographicChart chart(const SurfacePoint& from, const SurfacePoint& to,
                           double edgeLength) const {
    return {sphere_, from, to, edgeLength};
  }

 private:
  SphereSurface sphere_;
};

}  // namespace af2::geometry
