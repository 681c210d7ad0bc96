// A chart that projects along the normals of the surface to a plane, and back.
#pragma once

#include "geometry/charts/mean_normal_chart.h"

namespace af2::geometry {

/// Uses the plane of the published chart, but projects each point along its own surface normal, so
/// that a point of the plane corresponds to the nearest point of the surface. Away from the base
/// edge lengths grow, whereas orthogonal projection makes them shrink. Source: [VanderZee16],
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
  /// Each step reduces the error by the factor height / radius of curvature.
  static constexpr int kSteps = 3;

  /// The vector from the orthogonal projection of a point to its projection along its normal.
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
  SurfacePoint from_, to_;  // copies: the points of the front may be reallocated meanwhile
  ProjectionFrame frame_;
  double edgeLength_;
};

template <class Surface>
using NormalLineChartMaker = LimitedChartMaker<NormalLineChart, Surface>;

}  // namespace af2::geometry
