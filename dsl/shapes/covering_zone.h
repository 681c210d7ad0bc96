// Zones that can decide whether they contain a whole edge.
#pragma once

#include "engine/base/export.h"
#include "engine/rule/free_zone.h"

namespace af2::dsl {

/// A zone that can be subtracted from another zone, `s - t`, with correct answers for edges.
///
/// Derive the zone of a registered shape from this class instead of AF2FreeZone if rules may
/// subtract it. For other zones, an edge inside the zone counts as inside `s - t` wherever it
/// enters s. This refuses too many matches, but never too few.
class AF2_EXPORT CoveringZone : public AF2FreeZone {
 public:
  /// Whether the closed zone contains the whole edge.
  virtual bool covers(Point2 from, Point2 to) const = 0;
};

/// False if unknown. A convex polygon contains an edge if it contains its ends.
AF2_EXPORT bool covers(const AF2FreeZone& zone, Point2 from, Point2 to);

}  // namespace af2::dsl
