// Where a canvas draws: what does not depend on the library that writes its pictures.
#pragma once

#include "dsl/picture/canvas.h"

namespace af2::dsl::picture {

/// From the chart to pixels.
struct CanvasView {
  double scale = 0;  ///< pixels per unit; 0: there is no view, so that points are in pixels
  Point2 origin;     ///< pixel of the chart's origin

  /// `world` fits into the pixel box, centred.
  void fit(Point2 low, Point2 high, const Box2& world, double largestScale);
  Point2 pixel(Point2 p) const;
};

/// The head of an arrow from p to q, in pixels; empty if the arrow is too short for it.
Loop arrowHead(Point2 p, Point2 q, double width);

}  // namespace af2::dsl::picture
