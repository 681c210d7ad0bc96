// Angles from one direction to another.
// Not installed.
#pragma once

#include <cmath>
#include <numbers>

#include "engine/base/point.h"

namespace af2 {

inline constexpr double kFullTurn = 2 * std::numbers::pi;

/// The angle, in (0, 2 pi], of a direction whose sine and cosine are given up to a common factor.
inline double turnOf(double sine, double cosine) {
  const double angle = std::atan2(sine, cosine);
  return angle > 0 ? angle : angle + kFullTurn;
}

/// Angle counter-clockwise from one direction to another, in (0, 2 pi].
inline double turnBetween(Point2 from, Point2 to) { return turnOf(cross(from, to), dot(from, to)); }

}  // namespace af2
