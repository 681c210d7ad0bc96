// Many points of a surface mapped to one chart.
// Not installed.
#pragma once

#include "engine/base/pair.h"
#include "engine/step/neighborhood.h"

namespace af2 {

/// The place of a point in the chart.
struct Drawn {
  Pair position;
  ChartView view;
};

enum class FrameKind { Plane, Bent, Folding, Central };

/// ProjectionFrame::project for many points.
template <FrameKind kKind>
class FrameDrawing {
 public:
  explicit FrameDrawing(const ProjectionFrame& f)
      : frame_(f),
        origin_(f.origin),
        x_{f.xAxis.x, f.yAxis.x},
        y_{f.xAxis.y, f.yAxis.y},
        z_{f.xAxis.z, f.yAxis.z},
        scale_{f.scale, f.scale},
        centre_{f.centreX, 0} {}

  [[gnu::always_inline]] Drawn operator()(const SurfacePoint& point) const {
    const Point3 d = point.position - origin_;
    const Pair position =
        scale_ * (Pair{d.x, d.x} * x_ + Pair{d.y, d.y} * y_ + Pair{d.z, d.z} * z_);
    if constexpr (kKind == FrameKind::Plane) return {position, ChartView::Legal};
    if constexpr (kKind == FrameKind::Bent) {
      const ChartPoint p = frame_.bent(pointAt(position));
      return {Pair{p.position.x, p.position.y}, p.view};
    }
    if constexpr (kKind == FrameKind::Folding) return {position, frame_.viewOf(point, d)};
    const double stretch = 1 / (1 + frame_.perspective * dot(d, frame_.normal));
    return {centre_ + Pair{stretch, stretch} * (position - centre_), ChartView::Legal};
  }

 private:
  const ProjectionFrame& frame_;
  const Point3 origin_;
  const Pair x_, y_, z_, scale_, centre_;
};

/// A chart of any class.
class ChartDrawing {
 public:
  explicit ChartDrawing(const StepChart& chart) : chart_(chart) {}
  Drawn operator()(const SurfacePoint& point) const {
    const ChartPoint p = chart_.project(point);
    return {Pair{p.position.x, p.position.y}, p.view};
  }

 private:
  const StepChart& chart_;
};

/// Calls `use` with the fastest way to map points to the chart.
template <class Use>
void withDrawing(const StepChart& chart, const Use& use) {
  if (!chart.frame()) return use(ChartDrawing(chart));
  const ProjectionFrame& frame = *chart.frame();
  if (chart.isPlane() && frame.bend != Point2{0, 0})
    return use(FrameDrawing<FrameKind::Bent>(frame));
  if (chart.isPlane()) return use(FrameDrawing<FrameKind::Plane>(frame));
  if (frame.perspective != 0) return use(FrameDrawing<FrameKind::Central>(frame));
  use(FrameDrawing<FrameKind::Folding>(frame));
}

}  // namespace af2
