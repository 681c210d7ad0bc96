#include "engine/step/neighborhood.h"

#include <algorithm>

#include "engine/base/pair.h"
#include "engine/step/chart_drawing.h"

namespace af2 {

void DrawnBase::draw(const Front& front, const StepChart& chart, PlaceId base) {
  a.place = base;
  b.place = front.next(base);
  before.place = front.previous(base);
  after.place = front.next(b.place);
  withDrawing(chart, [&](const auto& drawing) {
    for (Corner* corner : {&before, &a, &b, &after}) {
      const Drawn drawn = drawing(front[corner->place].point);
      corner->point.position = pointAt(drawn.position);
      corner->point.view = drawn.view;
    }
  });
}

Box3 StepChart::boxOf(const Window& window, const Point3& origin) const {
  const Window w = frame_ && frame_->bend != Point2{0, 0} ? straightened(window) : window;
  if (!frame_) {
    // A chart of unknown class: its lengths are approximately right near the base, so the box is
    // generous.
    const double reach = 1.5 * unit_ * std::max({-w.lowX, -w.lowY, w.highX, w.highY});
    const Point3 r{reach, reach, reach};
    return {origin - r, origin + r};
  }
  const double halfX = 0.5 * (w.highX - w.lowX) * unit_, halfY = 0.5 * (w.highY - w.lowY) * unit_;
  const double midX = 0.5 * (w.highX + w.lowX) * unit_, midY = 0.5 * (w.highY + w.lowY) * unit_;
  const Heights heights = heightsWithin(w);
  const double halfZ = 0.5 * (heights.above + heights.below);
  const double midZ = 0.5 * (heights.above - heights.below);
  const Point3 center =
      frame_->origin + midX * frame_->xAxis + midY * frame_->yAxis + midZ * frame_->normal;
  const auto extent = [&](double x, double y, double n) {
    return std::abs(x) * halfX + std::abs(y) * halfY + std::abs(n) * halfZ;
  };
  const Point3 r{extent(frame_->xAxis.x, frame_->yAxis.x, frame_->normal.x),
                 extent(frame_->xAxis.y, frame_->yAxis.y, frame_->normal.y),
                 extent(frame_->xAxis.z, frame_->yAxis.z, frame_->normal.z)};
  return {center - r, center + r};
}

Window StepChart::straightened(const Window& w) const {
  constexpr double kFarthest = 3;
  const double reach = length(Point2{std::max(-w.lowX, w.highX), std::max(-w.lowY, w.highY)});
  const double change = length(frame_->bend) * reach +
                        distance(frame_->kept, Point2{1, 0});  // upper bound on the change of scale
  const double margin = reach * std::min(kFarthest, change / std::max(0.25, 1 - change));
  return {w.lowX - margin, w.lowY - margin, w.highX + margin, w.highY + margin};
}

StepChart::Heights StepChart::heightsWithin(const Window& w) const {
  if (isPlane()) return {0, 0};
  if (frame_->perspective == 0) {
    const double reach = std::max(w.highX - w.lowX, w.highY - w.lowY) * unit_;
    const double height = std::min(frame_->maxHeight, reach);
    return {height, height};
  }
  // How far a sphere through the centre that touches the plane falls below it in the window.
  const double x = std::max(frame_->centreX - w.lowX, w.highX - frame_->centreX);
  const double y = std::max(-w.lowY, w.highY);
  const double squaredReach = (x * x + y * y) * unit_ * unit_;
  const double p = std::abs(frame_->perspective);
  const double depth = p * squaredReach / (1 + p * p * squaredReach);
  return frame_->perspective > 0 ? Heights{depth, frame_->maxHeight}
                                 : Heights{frame_->maxHeight, depth};
}

void Neighborhood::gather(const Front& front, const FrontIndex& index, const StepChart& chart,
                          PlaceId base, const Window& window) {
  window_ = window;
  collected_ = index.collectNear(chart.boxOf(window, front[base].point.position), found_);
  if (edges_.size() <= collected_.count) edges_.resize(2 * collected_.count + 1);
  withDrawing(chart, [&](const auto& drawing) { draw(front, drawing); });
}

/// Two short loops that store every edge before testing whether it stays. A branch on whether an
/// edge lies in the window would be mispredicted often.
template <class Drawing>
void Neighborhood::draw(const Front& front, const Drawing& drawing) {
  const Pair low{window_.lowX, window_.lowY}, high{window_.highX, window_.highY};
  Edge* edge = edges_.data();
  for (const PlaceId id : std::span(found_.data(), collected_.count)) {
    const Place& place = front[id];
    const Place& end = front[place.level < 0 ? id : place.next];
    const Drawn from = drawing(place.point), to = drawing(end.point);
    edge->from = pointAt(from.position);
    edge->to = pointAt(to.position);
    edge->place = id;
    edge->vertex = place.vertex;
    edge->view = from.view;
    edge->isEdge = place.level > 0;
    const auto isInside =
        (larger(from.position, to.position) >= low) & (smaller(from.position, to.position) <= high);
    const bool isHidden = (from.view == ChartView::Hidden) & (to.view == ChartView::Hidden);
    edge += isHidden ? 0 : bothHold(isInside);
  }
  count_ = static_cast<std::size_t>(edge - edges_.data());
}

}  // namespace af2
