#include "geometry/domain/points_on_curve.h"

#include <algorithm>

namespace af2::geometry {

namespace {

/// The nearest point between two knots, where the curve is almost straight.
CurveFoot footBetween(const DomainCurve& curve, double low, double high, const Point3& point) {
  constexpr int kSteps = 3;  // a curve between knots that departs from its chord a little
  CurveFoot foot;
  for (int step = 0; step < kSteps; ++step) {
    const Point3 p = curve.pointAt(low), d = curve.pointAt(high) - p;
    const double within = dot(d, d) > 0 ? std::clamp(dot(point - p, d) / dot(d, d), 0.0, 1.0) : 0;
    foot.parameter = low + within * (high - low);
    foot.distance = distance(point, curve.pointAt(foot.parameter));
    const double reach = 0.05 * (high - low);
    low = std::max(low, foot.parameter - reach);
    high = std::min(high, foot.parameter + reach);
  }
  return foot;
}

}  // namespace

CurveFoot footOn(const DomainCurve& curve, const Point3& point) {
  CurveFoot best;
  for (std::size_t k = 1; k < curve.knots.size(); ++k) {
    const CurveFoot foot = footBetween(curve, curve.knots[k - 1], curve.knots[k], point);
    if (foot.distance < best.distance) best = foot;
  }
  return best;
}

double lengthOf(const DomainCurve& curve) {
  double length = 0;
  for (std::size_t k = 1; k < curve.knots.size(); ++k)
    length += distance(curve.pointAt(curve.knots[k - 1]), curve.pointAt(curve.knots[k]));
  return length;
}

PlacedPoints placeOnCurve(const DomainCurve& curve, const std::vector<Point3>& points,
                          std::size_t least) {
  requireSegments(curve.id, points.size(), least);
  return placePoints(
      curve.id, points,
      {curve.knots.front(), curve.knots.back(), toleranceOfPoints(lengthOf(curve), points.size())},
      [&](const Point3& point) { return footOn(curve, point); });
}

}  // namespace af2::geometry
