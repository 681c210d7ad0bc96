// Charts for a face that is laid out conformally in a plane, with a scale that varies.
#pragma once

#include "engine/surface/local_transform.h"
#include "geometry/charts/plane_map.h"

namespace af2::geometry {

/// The plane, turned so that the base edge is on the x axis and transformed by a Moebius map so
/// that lengths near the base edge equal those on the surface to first order. Without this map,
/// rules would not see that rows of elements get longer or shorter: in the plane, rows are straight
/// that bend on the surface.
class ConformalChart final : public AF2LocalTransform {
 public:
  /// from, to  in the plane z = 0
  ConformalChart(const PlaneMap& map, const SurfacePoint& from, const SurfacePoint& to,
                 double edgeLength);

  ChartPoint transformFromSurface(const SurfacePoint& point) const override {
    return frame_.project(point);
  }
  std::optional<SurfacePoint> transformToSurface(Point2 point) const override;
  const ProjectionFrame* projection() const override { return &frame_; }

 private:
  ProjectionFrame frame_;
  double edgeLength_;
};

/// For fronts that are laid out by a map.
class ConformalChartMaker final : public ChartMaker<ConformalChartMaker> {
 public:
  /// map  is kept as a reference
  explicit ConformalChartMaker(const PlaneMap& map) : map_(map) {}

  ConformalChart chart(const SurfacePoint& from, const SurfacePoint& to, double edgeLength) const {
    return {map_, from, to, edgeLength};
  }

 private:
  const PlaneMap& map_;
};

}  // namespace af2::geometry
