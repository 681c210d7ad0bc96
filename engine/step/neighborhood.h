// The front near one base edge, mapped to the chart; the buffer is reused from step to step.
#pragma once

#include <span>
#include <vector>

#include "engine/front/front.h"
#include "engine/front/front_index.h"
#include "engine/step/compiled_rules.h"
#include "engine/surface/local_transform.h"

namespace af2 {

/// One chart with its fast form, if it has one.
class StepChart {
 public:
  StepChart(const AF2LocalTransform& transform, double unit)
      : transform_(transform), frame_(transform.projection()), unit_(unit) {}

  ChartPoint project(const SurfacePoint& point) const {
    return frame_ ? frame_->project(point) : transform_.transformFromSurface(point);
  }
  /// Returned in registers: assembling it in memory and copying it would stall the processor.
  [[gnu::noinline]] Point2 positionOf(const SurfacePoint& point) const {
    return project(point).position;
  }
  std::optional<SurfacePoint> lift(Point2 point) const {
    return transform_.transformToSurface(point);
  }
  const ProjectionFrame* frame() const { return frame_; }
  /// Whether the projection alone decides: a surface without folds or other sheets.
  bool isPlane() const { return frame_ && frame_->minCosine <= -2 && frame_->perspective == 0; }
  double unit() const { return unit_; }  ///< the length, in model units, that is 1 in the chart
  /// A box in space that holds everything the window shows.
  Box3 boxOf(const Window& window, const Point3& origin) const;

 private:
  /// Holds everything that the window shows, before the frame bends it.
  Window straightened(const Window& window) const;
  /// How far the surface may extend below and above the plane of the frame, within the window.
  struct Heights {
    double below, above;
  };
  Heights heightsWithin(const Window& window) const;

  const AF2LocalTransform& transform_;
  const ProjectionFrame* frame_;
  double unit_;
};

/// The base edge a -> b of a step and the corners of the front before and after it, in the chart.
struct DrawnBase {
  struct Corner {
    PlaceId place;
    ChartPoint point;
  };
  Corner before, a, b, after;

  void draw(const Front& front, const StepChart& chart, PlaceId base);
};

/// All front edges that may meet a window. The start points of the edges are the vertices.
class Neighborhood {
 public:
  struct Edge {
    Point2 from, to;
    PlaceId place;
    VertexId vertex;  ///< the start point
    ChartView view;   ///< of the start point
    bool isEdge;      ///< false: only the vertex
  };

  void gather(const Front& front, const FrontIndex& index, const StepChart& chart, PlaceId base,
              const Window& window);

  std::span<const Edge> edges() const { return {edges_.data(), count_}; }
  const Window& window() const { return window_; }
  /// How many edges were visited for that.
  std::size_t lookedAt() const { return collected_.lookedAt; }

 private:
  template <class Drawing>
  void draw(const Front& front, const Drawing& drawing);

  Window window_;
  std::vector<PlaceId> found_;  // the collected edges are at the front
  FrontIndex::Collected collected_{0, 0};
  std::vector<Edge> edges_;  // [0, count_) are in use
  std::size_t count_ = 0;
};

}  // namespace af2
