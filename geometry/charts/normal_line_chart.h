// Along the normals of the surface down to a plane, and back to where these came from.
#pragma once

#include "geometry/charts/mean_normal_chart.h"

namespace af2::geometry {

/// On the plane of the published chart, but each point goes down along its own normal, so that a
/// point of the plane comes from the point of the surface that is nearest to it. Lengths grow away
/// from the base edge, where orthogonal projection makes them shrink. Source: [VanderZee16],
/// further work.
///
/// Surface  as for MeanNormalChart
template <class Surface>
class NormalLineChart final : public AF2LocalTransform {
 public:
  NormalLineChart(const Surface& surface, const SurfacePoint& from, const SurfacePoint& to,
                  double edgeLength, const ChartLimits& limits)
      : surface_(surface),
        from_(from),
        to_(to),
        frame_(meanNormalFrame(from, to, edgeLength, limits)),
        edgeLength_(edgeLength) {}

  ChartPoint transformFromSurface(const SurfacePoint& point) const override {
    ChartPoint p = frame_.project(point);
    if (p.view == ChartView::Legal) p.position = p.position + driftOf(point);
    return p;
  }

  std::optional<SurfacePoint> transformToSurface(Point2 point) const override {
    std::optional<SurfacePoint> hit = hitAt(point);
    for (int step = 0; hit && step < kSteps; ++step) hit = hitAt(point - driftOf(*hit));
    if (!hit || frame_.project(*hit).view != ChartView::Legal) return std::nullopt;
    return hit;
  }

 private:
  /// Each takes the error down by the height over the radius of curvature.
  static constexpr int kSteps = 3;

  /// From where orthogonal projection puts a point to where its normal does.
  Point2 driftOf(const SurfacePoint& point) const {
    const double height = dot(point.position - frame_.origin, frame_.normal);
    const double factor = -frame_.scale * height / dot(point.normal, frame_.normal);
    return {factor * dot(point.normal, frame_.xAxis), factor * dot(point.normal, frame_.yAxis)};
  }
  std::optional<SurfacePoint> hitAt(Point2 point) const {
    const auto hit = surface_.hit(lineAt(frame_, point, from_, to_, edgeLength_));
    if (!hit || frame_.project(*hit).view != ChartView::Legal) return std::nullopt;
    return hit;
  }

  const Surface& surface_;
  SurfacePoint from_, to_;  // copies: the front may move while the chart is in use
  ProjectionFrame frame_;
  double edgeLength_;
};

template <class Surface>
using NormalLineChartMaker = LimitedChartMaker<NormalLineChart, Surface>;

}  // namespace af2::geometry
