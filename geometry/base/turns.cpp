#include "geometry/base/turns.h"

#include <cmath>

namespace af2::geometry {

namespace {

// A quarter of a turn in two parts: multiples of the first, up to a million, are exact.
constexpr double kQuarter = 1.57079632673412561417e+00, kQuarterRest = 6.07710050650619224932e-11;

/// Taylor's series up to an eighth of a turn.
double sineOfSmall(double x) {
  const double s = x * x;
  double sum = 0;
  for (int k = 17; k >= 3; k -= 2) sum = (1 + sum) * (-s / (k * (k - 1)));
  return x + x * sum;
}

double cosineOfSmall(double x) {
  const double s = x * x;
  double sum = 0;
  for (int k = 18; k >= 2; k -= 2) sum = (1 + sum) * (-s / (k * (k - 1)));
  return 1 + sum;
}

/// Of a ratio in [0, 1]: the angle is halved twice, then the series is short.
double arcTangent(double ratio) {
  double t = ratio;
  for (int i = 0; i < 2; ++i) t = t / (1 + std::sqrt(1 + t * t));
  const double s = t * t;
  double sum = 0;
  for (int k = 25; k >= 3; k -= 2) sum = s * (1.0 / k - sum);
  return 4 * (t - t * sum);
}

}  // namespace

Point2 directionAt(double angle) {
  const double quarters = std::floor(angle / (kPi / 2) + 0.5);
  const double rest = (angle - quarters * kQuarter) - quarters * kQuarterRest;
  const double c = cosineOfSmall(rest), s = sineOfSmall(rest);
  switch (static_cast<long long>(quarters) & 3) {
    case 0:
      return {c, s};
    case 1:
      return {-s, c};
    case 2:
      return {-c, -s};
    default:
      return {s, -c};
  }
}

double angleOf(Point2 direction) {
  const double x = std::abs(direction.x), y = std::abs(direction.y);
  if (x == 0 && y == 0) return 0;
  const double first = y <= x ? arcTangent(y / x) : kPi / 2 - arcTangent(x / y);
  const double upper = direction.x < 0 ? kPi - first : first;
  return direction.y < 0 ? -upper : upper;
}

}  // namespace af2::geometry
