// The chart of a plane: the plane itself, rotated so that the base edge lies on the x axis.
#pragma once

#include "engine/base/export.h"
#include "engine/surface/local_transform.h"

namespace af2 {

/// Exact in both directions and defined everywhere.
class AF2_EXPORT PlaneChart final : public AF2LocalTransform {
 public:
  PlaneChart(const SurfacePoint& from, const SurfacePoint& to, const Point3& normal,
             double edgeLength);

  ChartPoint transformFromSurface(const SurfacePoint& point) const override {
    return frame_.project(point);
  }
  std::optional<SurfacePoint> transformToSurface(Point2 point) const override {
    const Point3 position = frame_.origin + edgeLength_ * (point.x * frame_.xAxis) +
                            edgeLength_ * (point.y * frame_.yAxis);
    return SurfacePoint{position, frame_.normal, position.x, position.y};
  }
  const ProjectionFrame* projection() const override { return &frame_; }

 private:
  ProjectionFrame frame_;
  double edgeLength_;
};

/// Makes the charts of one plane.
class PlaneChartMaker final : public ChartMaker<PlaneChartMaker> {
 public:
  /// normal  any nonzero length, pointing to the side from which the region is seen
  explicit PlaneChartMaker(const Point3& normal = {0, 0, 1}) : normal_(unit(normal)) {}

  PlaneChart chart(const SurfacePoint& from, const SurfacePoint& to, double edgeLength) const {
    return {from, to, normal_, edgeLength};
  }

 private:
  Point3 normal_;
};

}  // namespace af2
