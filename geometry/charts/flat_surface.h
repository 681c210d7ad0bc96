// A plane as the surface of a face.
#pragma once

#include "engine/surface/plane_chart.h"
#include "geometry/charts/charted_surface.h"

namespace af2::geometry {

class FlatSurface final : public ChartedSurface {
 public:
  /// x, y  unit vectors of the parameters, perpendicular to each other; the face is seen from where
  ///       they turn counter-clockwise
  FlatSurface(const Point3& origin, const Point3& x, const Point3& y)
      : origin_(origin), x_(x), y_(y), normal_(cross(x, y)) {}

  bool isPlane() const override { return true; }
  bool has(ChartKind kind) const override {
    return kind == ChartKind::Auto || kind == ChartKind::Plane;
  }
  std::unique_ptr<AF2LocalTransformMaker> makeCharts(ChartKind) const override {
    return std::make_unique<PlaneChartMaker>(normal_);
  }
  SurfacePoint at(double u, double v) const override {
    return {origin_ + u * x_ + v * y_, normal_, u, v};
  }
  /// A point of the plane, with its parameters.
  SurfacePoint pointAt(const Point3& position) const {
    const Point3 d = position - origin_;
    return {position, normal_, dot(d, x_), dot(d, y_)};
  }

 private:
  Point3 origin_, x_, y_, normal_;
};

}  // namespace af2::geometry
