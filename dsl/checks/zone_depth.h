// How far points and elements stick out of a free zone.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "engine/free_zone.h"

namespace af2::dsl {

/// A zone with its outline, so that distances to it can be measured.
class MeasuredZone {
 public:
  explicit MeasuredZone(const AF2FreeZone& zone);

  /// 0 for points of the closed zone, else the distance to it.
  double depthOutside(Point2 point) const;

  /// Depths up to this come from rounding, or from arcs measured as chords.
  double tolerance() const { return isConvex_ ? 1e-6 : 1e-4; }

  struct Poke {
    double depth = 0;
    Point2 at;
  };
  /// The deepest point of an element outside: of its corners for a convex zone, else of many points
  /// along its edges.
  Poke pokeOf(std::span<const Point2> corners) const;

  /// Worked out when first asked for; most zones are never measured, for nothing sticks out of
  /// them.
  const std::vector<std::vector<Point2>>& outlineLoops() const;

 private:
  const AF2FreeZone& zone_;
  mutable std::optional<std::vector<std::vector<Point2>>> loops_;
  bool isConvex_;
};

}  // namespace af2::dsl
