// Angles from one direction to another.
// Not installed.
#pragma once

#include <cmath>
#include <numbers>

#include "engine/base/elementary.h"
#include "engine/base/point.h"

namespace af2 {

inline constexpr double kFullTurn = 2 * std::numbers::pi;

/// The angle, in (0, 2 pi], of a direction whose sine and cosine are given up to a common factor.
inline double turnOf(double sine, double cosine) {
  const double angle = angleOf({cosine, sine});
  return angle > 0 ? angle : angle + kFullTurn;
}

/// Angle counter-clockwise from one direction to another, in (0, 2 pi].
inline double turnBetween(Point2 from, Point2 to) { return turnOf(cross(from, to), dot(from, to)); }

/// Increases with the same angle, in (0, 4]; a quarter turn is 1.
inline double sweepOf(double sine, double cosine) {
  const double size = std::abs(cosine) + std::abs(sine);
  if (!(size > 0)) return 4;
  const double p = sine / size;
  const double angle = cosine < 0 ? 2 - p : p < 0 ? 4 + p : p;
  return angle > 0 ? angle : 4;
}

/// `sweepOf` an angle in radians, in (0, 2 pi].
inline double sweepOfAngle(double angle) {
  const Point2 direction = directionAt(angle);
  return sweepOf(direction.y, direction.x);
}

}  // namespace af2
