// The distance by which points and elements extend beyond a free zone.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "engine/rule/free_zone.h"

namespace af2::dsl {

/// A place in the interior of a convex element, close to its edges, that is outside the closed
/// zone, so that an obstacle there would not be noticed. Answers are exact for the given numbers.
/// The search tries the corners if the zone is convex, otherwise many points along the edges.
std::optional<Point2> unseenPlace(const AF2FreeZone& zone, std::span<const Point2> element);

bool isConvexPolygon(const AF2FreeZone& zone);

/// A zone with its outline, so that distances to it can be measured.
class MeasuredZone {
 public:
  explicit MeasuredZone(const AF2FreeZone& zone);

  /// 0 for points of the closed zone, else the distance to it.
  double depthOutside(Point2 point) const;

  /// Computed on first use, because most zones contain their elements and are never measured.
  const std::vector<std::vector<Point2>>& outlineLoops() const;

 private:
  const AF2FreeZone& zone_;
  mutable std::optional<std::vector<std::vector<Point2>>> loops_;
};

}  // namespace af2::dsl
