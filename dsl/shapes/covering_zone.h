// Zones that can say of an edge whether they hold all of it.
#pragma once

#include "engine/base/export.h"
#include "engine/rule/free_zone.h"

namespace af2::dsl {

/// A zone that may be taken away from another one, `s - t`, edge by edge.
///
/// Derive a registered shape's zone from this rather than from AF2FreeZone if rules are to take it
/// away. Of one that does not answer, an edge in it counts as in `s - t` wherever it enters s,
/// which refuses more than it must and never less.
class AF2_EXPORT CoveringZone : public AF2FreeZone {
 public:
  /// Whether the whole edge lies in the closed zone.
  virtual bool covers(Point2 from, Point2 to) const = 0;
};

/// No if it is not known. A convex polygon holds an edge if it holds its ends.
AF2_EXPORT bool covers(const AF2FreeZone& zone, Point2 from, Point2 to);

}  // namespace af2::dsl
