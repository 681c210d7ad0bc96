// What the shape of an element's corner costs, as a function of the place of one vertex.
#pragma once

#include <cmath>

#include "engine/base/point.h"

namespace af2 {

/// A sum of costs with its first and second derivatives.
struct CornerSum {
  double value = 0;
  Point2 slope;
  double xx = 0, xy = 0, yy = 0;
};

/// A corner between the sides `ahead` and `behind`.
///
/// The cost is 1 / s^2 + 1/4 (mean / geometric mean of the squared sides)^2, where s is the sine of
/// the corner, scaled so that an ideal one has 1. Where s is small or negative, the first term goes
/// on as a steep line, so that a smaller sum always means elements that are nearer to being sound.
struct CornerShape {
  static constexpr double kFlat = 0.05, kSides = 0.25;

  Point2 ahead, behind;
  double scale;  ///< of the sine: 1 for a quadrilateral, 2 / sqrt(3) for a triangle

  double area() const { return scale * cross(ahead, behind); }
  /// Whether the corner turns left so plainly that `addTo` may be called.
  bool isSound() const {
    const double c = area();
    return c > 0 && c * c > kFlat * kFlat * dot(ahead, ahead) * dot(behind, behind);
  }
  double scaledJacobian() const {
    const double product = std::sqrt(dot(ahead, ahead) * dot(behind, behind));
    return product > 0 ? area() / product : -1;
  }
  double cost() const {
    const double ee = dot(ahead, ahead), ff = dot(behind, behind);
    if (!(ee > 0 && ff > 0)) return 1e12;
    const double sides = 0.25 * kSides * (ee + ff) * (ee + ff) / (ee * ff);
    const double c = area();
    if (isSound()) return ee * ff / (c * c) + sides;
    constexpr double kSteep = 1 / (kFlat * kFlat);
    return kSteep + 2 * kSteep / kFlat * (kFlat - c / std::sqrt(ee * ff)) + sides;
  }
  /// Adds the cost and its derivatives by the place x of a vertex on which the sides depend.
  ///
  /// byAhead, byBehind  derivatives of the sides by x: -1, 0 or 1 times the identity
  void addTo(CornerSum& sum, double byAhead, double byBehind) const;
};

}  // namespace af2
