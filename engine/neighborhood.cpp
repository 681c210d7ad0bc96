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
  window_ = window;
  found_.clear();
  index.forEachNear(front, chart.boxOf(window, front[base].point.position),
                    [&](PlaceId id) { found_.push_back(id); });
  if (edges_.size() < found_.size()) edges_.resize(2 * found_.size());
  if (chart.frame())
    draw(front, *chart.frame());
  else
    draw(front, chart);
}

/// Two short loops, and storing every edge before knowing whether it stays, keep the processor
/// busy: which edges lie in the window is not to be guessed.
template <class Projection>
void Neighborhood::draw(const Front& front, const Projection& given) {
  const Projection projection = given;
  const Window window = window_;
  Edge* edge = edges_.data();
  for (PlaceId id : found_) {
    const Place& place = front[id];
    const Place& end = place.level < 0 ? place : front[place.next];
    const ChartPoint from = projection.project(place.point), to = projection.project(end.point);
    *edge = {from.position, to.position, id, from.view};
    const bool isInside = (std::max(from.position.x, to.position.x) >= window.lowX) &
                          (std::min(from.position.x, to.position.x) <= window.highX) &
                          (std::max(from.position.y, to.position.y) >= window.lowY) &
                          (std::min(from.position.y, to.position.y) <= window.highY) &
                          !((from.view == ChartView::Hidden) & (to.view == ChartView::Hidden));
    edge += isInside;
  }
  count_ = static_cast<std::size_t>(edge - edges_.data());
}

}  // namespace af2
