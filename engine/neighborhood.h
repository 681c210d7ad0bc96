// The front near one base edge, drawn in the chart: structure of arrays, reused from step to step.
#pragma once

#include <vector>

#include "engine/compiled_rules.h"
#include "engine/front.h"
#include "engine/front_index.h"
#include "engine/local_transform.h"

namespace af2 {

/// One chart with its fast form at hand.
class StepChart {
 public:
  StepChart(const AF2LocalTransform& transform, double unit)
      : transform_(transform), frame_(transform.projection()), unit_(unit) {}

  ChartPoint project(const SurfacePoint& point) const {
    return frame_ ? frame_->project(point) : transform_.transformFromSurface(point);
  }
  std::optional<SurfacePoint> lift(Point2 point) const {
    return transform_.transformToSurface(point);
  }
  const ProjectionFrame* frame() const { return frame_; }
  double unit() const { return unit_; }  ///< what is length 1 in the chart, in model units
  /// A box in space that holds what the window shows.
  Box3 boxOf(const Window& window, const Point3& origin) const;

 private:
  const AF2LocalTransform& transform_;
  const ProjectionFrame* frame_;
  double unit_;
};

/// Every edge of the front that may meet a window. The start points of the edges are the vertices.
class Neighborhood {
 public:
  void gather(const Front& front, const FrontIndex& index, const StepChart& chart, PlaceId base,
              const Window& window);

  std::size_t count() const { return places_.size(); }
  PlaceId place(std::size_t i) const { return places_[i]; }
  Point2 from(std::size_t i) const { return {fromX_[i], fromY_[i]}; }
  Point2 to(std::size_t i) const { return {toX_[i], toY_[i]}; }
  bool isLegal(std::size_t i) const { return views_[i] == ChartView::Legal; }
  const Window& window() const { return window_; }

 private:
  void clear();

  Window window_;
  std::vector<PlaceId> places_;
  std::vector<double> fromX_, fromY_, toX_, toY_;
  std::vector<ChartView> views_;  // of the start points
};

}  // namespace af2
