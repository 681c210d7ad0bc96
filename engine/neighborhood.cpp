#include "engine/neighborhood.h"

#include <algorithm>

namespace af2 {

Box3 StepChart::boxOf(const Window& w, const Point3& origin) const {
  if (!frame_) {
    // A chart of unknown kind: its lengths are about right near the base, so look generously
    // around.
    const double reach = 1.5 * unit_ * std::max({-w.lowX, -w.lowY, w.highX, w.highY});
    const Point3 r{reach, reach, reach};
    return {origin - r, origin + r};
  }
  const double halfX = 0.5 * (w.highX - w.lowX) * unit_, halfY = 0.5 * (w.highY - w.lowY) * unit_;
  const double midX = 0.5 * (w.highX + w.lowX) * unit_, midY = 0.5 * (w.highY + w.lowY) * unit_;
  const bool isPlane = frame_->minCosine <= -2;
  const double height = isPlane ? 0 : std::min(frame_->maxHeight, 2 * std::max(halfX, halfY));
  const Point3 center = frame_->origin + midX * frame_->xAxis + midY * frame_->yAxis;
  const auto extent = [&](double x, double y, double n) {
    return std::abs(x) * halfX + std::abs(y) * halfY + std::abs(n) * height;
  };
  const Point3 r{extent(frame_->xAxis.x, frame_->yAxis.x, frame_->normal.x),
                 extent(frame_->xAxis.y, frame_->yAxis.y, frame_->normal.y),
                 extent(frame_->xAxis.z, frame_->yAxis.z, frame_->normal.z)};
  return {center - r, center + r};
}

void Neighborhood::gather(const Front& front, const FrontIndex& index, const StepChart& chart,
                          PlaceId base, const Window& window) {
  edges_.clear();
  window_ = window;
  const Box3 box = chart.boxOf(window, front[base].point.position);
  index.forEachNear(front, box, [&](PlaceId id) {
    const Place& place = front[id];
    const ChartPoint from = chart.project(place.point);
    const ChartPoint to = place.level < 0 ? from : chart.project(front[place.next].point);
    const bool isOutside = std::max(from.position.x, to.position.x) < window.lowX ||
                           std::min(from.position.x, to.position.x) > window.highX ||
                           std::max(from.position.y, to.position.y) < window.lowY ||
                           std::min(from.position.y, to.position.y) > window.highY;
    if (isOutside || (from.view == ChartView::Hidden && to.view == ChartView::Hidden)) return;
    edges_.push_back({from.position, to.position, id, from.view});
  });
}

}  // namespace af2
