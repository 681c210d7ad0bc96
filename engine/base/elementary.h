// Elementary functions by arithmetic alone: the same bits on every machine. The C library chooses
// among versions by the processor, and other C libraries round differently.
//
// Errors are below two units in the last place, those of the tangent below four.
#pragma once

#include "engine/base/point.h"

namespace af2 {

/// (cos, sin) of an angle in radians. Beyond 1e6 the angle itself is less accurate than the result.
Point2 directionAt(double angle);

inline double sine(double angle) { return directionAt(angle).y; }
inline double cosine(double angle) { return directionAt(angle).x; }
inline double tangent(double angle) {
  const Point2 direction = directionAt(angle);
  return direction.y / direction.x;
}

/// The angle of a direction, in [-pi, pi]; 0 for the zero vector. Coordinates are below 1e300.
double angleOf(Point2 direction);

/// The angle between two directions, in [0, pi]; 0 if one is the zero vector.
inline double angleBetween(const Point3& p, const Point3& q) {
  return angleOf({dot(p, q), length(cross(p, q))});
}

/// The natural logarithm: minus infinity of 0, no number for negative numbers.
double logarithm(double x);

/// e^x.
double exponential(double x);

/// No number for a negative base and an exponent that is not whole; 1 for the exponent 0.
double power(double base, double exponent);

}  // namespace af2
