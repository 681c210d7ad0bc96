// Fast tests of vertices and edges against the zone of a candidate, before or instead of exact
// ones. Not installed.
#pragma once

#include <cmath>

#include "engine/base/pair.h"
#include "engine/base/point.h"
#include "engine/rule/free_zone.h"
#include "engine/step/affine_batch.h"

namespace af2 {

/// The bounding box of a zone.
class ZoneBox {
 public:
  explicit ZoneBox(const Box2& box, double margin = 0)
      : low_(pairAt(box.low) - Pair{margin, margin}),
        high_(pairAt(box.high) + Pair{margin, margin}) {}
  bool holds(Point2 point) const { return isWithin(pairAt(point), pairAt(point)); }
  bool mayMeet(Point2 from, Point2 to) const {
    return isWithin(smaller(pairAt(from), pairAt(to)), larger(pairAt(from), pairAt(to)));
  }

 private:
  bool isWithin(Pair least, Pair greatest) const {
    return bothHold((greatest >= low_) & (least <= high_)) != 0;
  }
  Pair low_, high_;
};

/// In chart units, normally the wanted length there. Zones are tested exactly, and a new vertex is
/// often a corner of its zone. Where rows meet, rounding must therefore not decide whether the zone
/// sees a vertex that is already there. In a model a million lengths across, rounding moves
/// coordinates by 1e-10 lengths, and no front edge is as short as this limit.
inline constexpr double kSamePlace = 1e-9;

/// Whether an edge from a corner of a convex zone enters the zone, by a margin far larger than any
/// rounding error: the exact test would then find it, too.
inline bool plainlyRunsInto(const AffineBatch& zone, int corner, const Point2* matched, Point2 from,
                            Point2 to) {
  constexpr double kMargin = 1e-4;
  const int last = zone.count - 1;
  const Point2 before = zone.point(corner == 0 ? last : corner - 1, matched) - from;
  const Point2 after = zone.point(corner == last ? 0 : corner + 1, matched) - from;
  const Point2 edge = to - from;
  const double least = kMargin * (std::abs(edge.x) + std::abs(edge.y));
  return (cross(after, edge) > least) & (cross(edge, before) > least) &
         (cross(after, before) > kMargin);
}

}  // namespace af2
