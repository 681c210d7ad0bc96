// Measures of elements in the plane that increase with quality.
// Not installed.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>

#include "engine/base/elementary.h"
#include "engine/base/point.h"

namespace af2 {

/// The smallest sine of a corner, scaled to 1 for the ideal element; negative if a corner is
/// reflex, 0 if two corners coincide.
inline double scaledJacobian(std::span<const Point2> corners) {
  constexpr double kTwoOverRootThree = 1.1547005383792515;
  const std::size_t n = corners.size();
  double smallest = 1;
  for (std::size_t i = 0; i < n; ++i) {
    const Point2 ahead = corners[(i + 1) % n] - corners[i];
    const Point2 behind = corners[(i + n - 1) % n] - corners[i];
    const double product = std::sqrt(dot(ahead, ahead) * dot(behind, behind));
    const double sine = product > 0 ? cross(ahead, behind) / product : 0;
    smallest = std::min(smallest, n == 3 ? kTwoOverRootThree * sine : sine);
  }
  return smallest;
}

/// The smallest interior angle of an element without reflex corners, radians in [0, pi].
inline double smallestAngle(std::span<const Point2> corners) {
  const std::size_t n = corners.size();
  double smallest = std::numbers::pi;
  for (std::size_t i = 0; i < n; ++i) {
    const Point2 ahead = corners[(i + 1) % n] - corners[i];
    const Point2 behind = corners[(i + n - 1) % n] - corners[i];
    smallest = std::min(smallest, angleOf({dot(ahead, behind), std::abs(cross(ahead, behind))}));
  }
  return smallest;
}

}  // namespace af2
