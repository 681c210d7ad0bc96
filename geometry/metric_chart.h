// A chart in the parameters of a surface, with the surface's metric at the middle of the base edge.
// It cannot fold: the second choice where the published chart does.
#pragma once

#include "engine/local_transform.h"
#include "geometry/surface_frame.h"

namespace af2::geometry {

/// A surface by its parameters, as a metric chart needs it.
class ParametricSurface {
 public:
  using Frame = SurfaceFrame;
  virtual ~ParametricSurface() = default;
  virtual Frame frameAt(double u, double v) const = 0;
  /// With (u, v), position and normal of the face.
  virtual SurfacePoint pointAt(double u, double v) const = 0;
  /// Whether the normals of the face are opposite to du x dv.
  virtual bool isFlipped() const = 0;
};

/// Affine in (u, v); takes each corner of the front at its own parameters, so that the two sides of
/// a seam are apart.
class MetricChart final : public AF2LocalTransform {
 public:
  /// Throws GeometryError where the parameters are degenerate.
  MetricChart(const ParametricSurface& surface, const SurfacePoint& from, const SurfacePoint& to,
              double edgeLength);

  ChartPoint transformFromSurface(const SurfacePoint& point) const override {
    const double du = point.u - u_, dv = point.v - v_;
    return {{xu_ * du + xv_ * dv, yu_ * du + yv_ * dv}, ChartView::Legal};
  }
  std::optional<SurfacePoint> transformToSurface(Point2 point) const override {
    return surface_.pointAt(u_ + ux_ * point.x + uy_ * point.y, v_ + vx_ * point.x + vy_ * point.y);
  }

 private:
  const ParametricSurface& surface_;
  double u_, v_;              // of the start of the base edge
  double xu_, xv_, yu_, yv_;  // from parameters to the chart
  double ux_, uy_, vx_, vy_;  // and back
};

class MetricChartMaker final : public AF2LocalTransformMaker {
 public:
  /// surface  is kept as a reference
  explicit MetricChartMaker(const ParametricSurface& surface) : surface_(surface) {}

  std::unique_ptr<AF2LocalTransform> makeLocalTransform(const SurfacePoint& from,
                                                        const SurfacePoint& to,
                                                        double edgeLength) const override {
    return std::make_unique<MetricChart>(surface_, from, to, edgeLength);
  }
  const AF2LocalTransform& makeLocalTransformIn(ChartSlot& slot, const SurfacePoint& from,
                                                const SurfacePoint& to,
                                                double edgeLength) const override {
    return slot.emplace<MetricChart>(surface_, from, to, edgeLength);
  }

 private:
  const ParametricSurface& surface_;
};

}  // namespace af2::geometry
