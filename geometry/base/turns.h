// Angles and directions by arithmetic alone: the same bits on every machine, which no library of
// mathematical functions promises.
#pragma once

#include "engine/base/point.h"

namespace af2::geometry {

inline constexpr double kPi = 3.14159265358979323846;

/// (cos, sin) of an angle in radians, of size 1e6 at most; to a few units in the last place.
Point2 directionAt(double angle);

/// The angle of a direction, in [-pi, pi]; 0 for the zero vector.
double angleOf(Point2 direction);

}  // namespace af2::geometry
