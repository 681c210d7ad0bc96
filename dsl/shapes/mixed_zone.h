// Zones of shapes that have registered ones, of which nothing is known but what they answer, among
// their parts.
#pragma once

#include "dsl/shapes/shape.h"

namespace af2::dsl::shapes {

/// Whether a registered shape is among the parts.
bool isMixed(const Shape& shape);

/// The zone of a mixed shape.
///
/// Parts without registered shapes in them are one region, exact as ever. The zone answers for
/// points as its parts do, one by one. An edge meets a union if it meets a part; whether it meets
/// an intersection or a difference is found by halving it until the parts answer alike for a piece
/// or for its middle. Pieces of 2^-30 of the edge that are still open then count as in the zone. An
/// edge along a seam between a registered shape and another part is not seen.
MadeZone makeMixedZone(const Shape& shape);

/// isBounded for a mixed shape: a registered shape counts as bounded.
bool isBoundedMixed(const Shape& shape);

}  // namespace af2::dsl::shapes
