// Zones of shapes with registered shapes among their parts.
#pragma once

#include "dsl/shapes/shape.h"

namespace af2::dsl::shapes {

/// Whether the shape contains a registered shape.
bool isMixed(const Shape& shape);

/// The zone of a mixed shape.
///
/// Parts without registered shapes form one exact region. Queries for points combine the answers of
/// the parts. An edge meets a union if it meets a part. For an intersection or a difference, the
/// edge is bisected until the parts agree on a piece or its midpoint; a piece of 2^-30 of the edge
/// that is still undecided counts as inside the zone. An edge along a seam between a registered
/// shape and another part is not detected.
MadeZone makeMixedZone(const Shape& shape);

/// isBounded for a mixed shape: a registered shape counts as bounded.
bool isBoundedMixed(const Shape& shape);

}  // namespace af2::dsl::shapes
