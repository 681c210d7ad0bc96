#include "dsl/picture/canvas_view.h"

#include <algorithm>

namespace af2::dsl::picture {

void CanvasView::fit(Point2 low, Point2 high, const Box2& world, double largestScale) {
  const Point2 size = world.high - world.low;
  scale = std::min({largestScale, (high.x - low.x) / size.x, (high.y - low.y) / size.y});
  const Point2 middle = 0.5 * (world.low + world.high);
  origin = {0.5 * (low.x + high.x) - scale * middle.x, 0.5 * (low.y + high.y) + scale * middle.y};
}

Point2 CanvasView::pixel(Point2 p) const {
  if (scale == 0) return p;
  return {origin.x + scale * p.x, origin.y - scale * p.y};
}

/// It is a little beyond the middle, away from the vertices.
Loop arrowHead(Point2 p, Point2 q, double width) {
  const double size = distance(p, q);
  if (size < 12) return {};
  const double head = 6 + 1.8 * width;
  const Point2 along = (1 / size) * (q - p), aside{-along.y, along.x};
  const Point2 tip = 0.5 * (p + q) + (0.6 * head) * along, back = tip - head * along;
  return {tip, back + (0.42 * head) * aside, back + (0.25 * head) * along,
          back - (0.42 * head) * aside};
}

void Canvas::label(const std::string& text, Point2 at, Point2 direction, double distance,
                   const TextStyle& style) {
  const double size = length(direction);
  const Point2 unit = size > 0 ? (1 / size) * direction : Point2{0, 1};
  const Point2 p = pixel(at) + distance * Point2{unit.x, -unit.y};
  TextStyle centred = style;
  centred.anchor = Anchor::Middle;
  this->text(text, {p.x, p.y + 0.36 * style.size}, centred);
}

}  // namespace af2::dsl::picture
