// Whole turns of angles, and sharp turns of normals.
#pragma once

#include <cmath>
#include <numbers>

#include "engine/base/point.h"

namespace af2::geometry {

inline constexpr double kPi = std::numbers::pi;

/// The number of whole turns to add to an angle so that it is nearest to another one.
inline double turnsTowards(double angle, double near) {
  return std::floor((near - angle) / (2 * kPi) + 0.5);
}

/// The value shifted by whole periods into [low, low + period).
inline double intoPeriod(double value, double low, double period) {
  return value - std::floor((value - low) / period) * period;
}

/// Whether two normals differ by more than a smooth surface bends from one place to the next. A
/// zero normal (unknown) never differs.
inline bool differSharply(const Point3& one, const Point3& other) {
  constexpr double kSharp = 0.85;  // cosine
  return dot(one, other) < kSharp * length(one) * length(other);
}

}  // namespace af2::geometry
