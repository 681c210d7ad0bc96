// Where the corners of a list zone lie at a match.
#pragma once

#include <vector>

#include "engine/rule/free_zone.h"

namespace af2::dsl {

/// In the order of the clause, convex or not; empty if a corner has no value.
std::vector<Point2> cornersAt(const ConvexPolygonZoneDef& zone, const AF2Binding& binding);

}  // namespace af2::dsl
