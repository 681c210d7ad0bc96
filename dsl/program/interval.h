// Interval arithmetic: results contain the result for all members, including rounding errors.
#pragma once

#include <limits>

namespace af2::dsl {

/// All numbers from low to high; the bounds may be infinite.
struct Interval {
  double low = 0, high = 0;

  static constexpr double kInfinity = std::numeric_limits<double>::infinity();
  static constexpr Interval all() { return {-kInfinity, kInfinity}; }
  static constexpr Interval point(double x) { return {x, x}; }

  double width() const { return high - low; }
  double middle() const { return 0.5 * (low + high); }
  bool isPoint() const { return low == high; }
  bool isZero() const { return low == 0 && high == 0; }
  bool isFinite() const;
  bool contains(double x) const { return low <= x && x <= high; }
  bool operator==(const Interval&) const = default;
};

Interval operator+(Interval a, Interval b);
Interval operator-(Interval a, Interval b);
Interval operator-(Interval a);
/// Zero times any interval is zero, even if the other interval is unbounded.
Interval operator*(Interval a, Interval b);
/// All numbers if the divisor may be zero.
Interval operator/(Interval a, Interval b);

/// The smallest interval that contains both.
Interval hull(Interval a, Interval b);
/// The intersection. The caller knows that it is not empty, except for rounding.
Interval common(Interval a, Interval b);

Interval squareRoot(Interval a);  ///< of its non-negative members
Interval sine(Interval a);
Interval cosine(Interval a);
Interval absolute(Interval a);
Interval minimum(Interval a, Interval b);
Interval maximum(Interval a, Interval b);
Interval wholePower(Interval a, int exponent);
/// Requires members > 0; returns all numbers if there are others.
Interval power(Interval a, Interval exponent);
/// The angle of (x, y) in [-pi, pi].
Interval angleOf(Interval y, Interval x);

}  // namespace af2::dsl
