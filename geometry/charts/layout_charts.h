// The charts of a surface that is known by triangles.
// Not installed.
#pragma once

#include <memory>
#include <utility>

#include "engine/base/error.h"
#include "geometry/charts/charted_surface.h"
#include "geometry/charts/mean_normal_chart.h"
#include "geometry/charts/normal_line_chart.h"

namespace af2::geometry {

/// The mean-normal charts; also charts in the layout of the surface in one plane, if it has one,
/// else along the normals.
///
/// Surface  has `isDrawn`, `pointAt`, `frameAt`, and what the charts ask for
template <class Surface>
class LayoutCharts final : public ChartedSurface, public ParametricSurface {
 public:
  explicit LayoutCharts(Surface surface) : surface_(std::move(surface)) {}

  bool isPlane() const override { return false; }
  bool has(ChartKind kind) const override {
    switch (kind) {
      case ChartKind::Auto:
      case ChartKind::MeanNormal:
      case ChartKind::NormalLines:
        return true;
      case ChartKind::Affine:
        return surface_.isDrawn();
      default:
        return false;
    }
  }
  std::unique_ptr<AF2LocalTransformMaker> makeCharts(ChartKind kind) const override {
    if (kind == ChartKind::Affine)
      return std::make_unique<MetricChartMaker>(*this, MetricOrder::First);
    if (kind == ChartKind::NormalLines)
      return std::make_unique<NormalLineChartMaker<Surface>>(surface_);
    return std::make_unique<MeanNormalChartMaker<Surface>>(surface_);
  }
  const ParametricSurface* inParameters() const override {
    return surface_.isDrawn() ? this : nullptr;
  }
  /// Throws GeometryError if the surface has no layout in a plane.
  SurfacePoint at(double u, double v) const override {
    if (!surface_.isDrawn()) throw GeometryError("the surface has no layout in a plane");
    return surface_.pointAt(u, v);
  }
  Frame frameAt(double u, double v) const override { return surface_.frameAt(u, v); }
  SurfacePoint pointAt(double u, double v) const override { return surface_.pointAt(u, v); }
  bool isFlipped() const override { return false; }

 private:
  Surface surface_;
};

}  // namespace af2::geometry
