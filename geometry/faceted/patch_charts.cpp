#include "geometry/faceted/patch_charts.h"

#include "engine/base/error.h"
#include "geometry/charts/normal_line_chart.h"

namespace af2::geometry {

bool PatchCharts::has(ChartKind kind) const {
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

std::unique_ptr<AF2LocalTransformMaker> PatchCharts::makeCharts(ChartKind kind) const {
  if (kind == ChartKind::Affine)
    return std::make_unique<MetricChartMaker>(*this, MetricOrder::First);
  if (kind == ChartKind::NormalLines)
    return std::make_unique<NormalLineChartMaker<FacetSurface>>(surface_);
  return std::make_unique<MeanNormalChartMaker<FacetSurface>>(surface_);
}

SurfacePoint PatchCharts::at(double u, double v) const {
  if (!surface_.isDrawn()) throw GeometryError("the patch has no layout in a plane");
  return surface_.pointAt(u, v);
}

}  // namespace af2::geometry
