// Charts in a plane that a face is laid out in with lengths that vary.
#pragma once

#include "engine/surface/local_transform.h"
#include "geometry/charts/plane_map.h"

namespace af2::geometry {

/// The plane, turned so that the base edge lies on the x axis, and bent by a fraction of complex
/// numbers so that lengths about the base edge are those on the surface to first order. Without
/// this, rows of elements would not know that they grow longer or shorter: in the plane they are
/// straight where on the surface they bend.
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
