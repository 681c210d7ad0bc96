// Closed paths of straight steps and circular arcs: validity and orientation.
#pragma once

#include <optional>
#include <vector>

#include "dsl/shapes/shape.h"

namespace af2::dsl::shapes {

/// One step of a closed path. The next step begins at its end.
struct Step {
  Point2 from, to;
  std::optional<Point2> via;  ///< strictly to one side of the chord, if given
};

/// The steps of a Poly without steps of zero length; arcs along their chord become straight.
///
/// Nothing if a step is invalid: an arc that ends at its start, or whose `via` is on the line of
/// the chord but outside of the chord.
std::optional<std::vector<Step>> stepsOf(const Shape& poly);

/// Whether no two steps have a common point other than the corner between them. Exact.
bool isSimple(const std::vector<Step>& path);

/// Twice the signed area enclosed; the sign is exact for simple paths of straight steps.
double windingOf(const std::vector<Step>& path);

}  // namespace af2::dsl::shapes
