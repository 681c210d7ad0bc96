// Angles in units of 30 degrees: what ideal elements have at their corners, and what vertices want.
#pragma once

#include <algorithm>
#include <cmath>

#include "engine/mesh/mesh.h"

namespace af2 {

inline constexpr int kFullTurn = 12, kRightAngle = 3;

/// At each corner of an ideal triangle or quadrilateral.
inline int idealAngle(const Element& element) { return element.isQuad() ? kRightAngle : 2; }

/// The nearest number of units, at least 1. angle in radians
inline int angleInUnits(double angle) {
  return std::max(1, static_cast<int>(std::lround(angle / (M_PI / 6))));
}

}  // namespace af2
