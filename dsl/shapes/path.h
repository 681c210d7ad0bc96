// Closed paths of straight steps and circular arcs: are they simple, which way do they run?
#pragma once

#include <optional>
#include <vector>

#include "dsl/shapes/shape.h"

namespace af2::dsl::shapes {

/// One step of a closed path. The next one begins where it ends.
struct Step {
  Point2 from, to;
  std::optional<Point2> via;  ///< strictly to one side of the chord, if given
};

/// The steps of a Poly, less those of no length, arcs along their chord made straight.
///
/// Nothing if a step cannot be drawn: an arc that ends where it begins, or whose `via` lies on the
/// chord's line beyond its ends.
std::optional<std::vector<Step>> stepsOf(const Shape& poly);

/// Whether no two steps have a point in common but the corner between them. Exact.
bool isSimple(const std::vector<Step>& path);

/// Twice the signed area enclosed; the sign is exact for simple paths of straight steps.
double windingOf(const std::vector<Step>& path);

}  // namespace af2::dsl::shapes
