#include "geometry/points_on_curve.h"

#include <algorithm>
#include <cstdio>
#include <string>

#include "engine/error.h"

namespace af2::geometry {

namespace {

std::string textOf(const Point3& p) {
  char text[96];
  std::snprintf(text, sizeof text, "(%.9g, %.9g, %.9g)", p.x, p.y, p.z);
  return text;
}

[[noreturn]] void refuse(int edge, std::size_t index, const Point3& point,
                         const std::string& fault) {
  throw InputError("point " + std::to_string(index + 1) + " given for edge " +
                   std::to_string(edge) + ", " + textOf(point) + ": " + fault);
}

struct Foot {
  double parameter = 0, distance = DomainCurve::kNoLimit;
};

/// The nearest point between two knots, where the curve is all but straight.
Foot footBetween(const DomainCurve& curve, double low, double high, const Point3& point) {
  constexpr int kSteps = 3;  // a curve between knots that departs from its chord a little
  Foot foot;
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

Foot footOn(const DomainCurve& curve, const Point3& point) {
  Foot best;
  for (std::size_t k = 1; k < curve.knots.size(); ++k) {
    const Foot foot = footBetween(curve, curve.knots[k - 1], curve.knots[k], point);
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

}  // namespace

PlacedPoints placeOnCurve(const DomainCurve& curve, std::vector<Point3> points, std::size_t least) {
  constexpr double kShareOfSegment = 0.01;
  if (points.size() + 1 < least)
    throw InputError("the points given for edge " + std::to_string(curve.id) + " make " +
                     std::to_string(points.size() + 1) + " segments; it needs at least " +
                     std::to_string(least) + ", or it would share a segment");
  const double tolerance =
      kShareOfSegment * lengthOf(curve) / static_cast<double>(points.size() + 1);
  PlacedPoints placed;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Foot foot = footOn(curve, points[i]);
    if (!(foot.distance <= tolerance))
      refuse(curve.id, i, points[i],
             "it lies " + std::to_string(foot.distance) + " beside the edge");
    placed.parameters.push_back(foot.parameter);
  }
  if (points.size() > 1 && placed.parameters.front() > placed.parameters.back()) {
    std::reverse(points.begin(), points.end());
    std::reverse(placed.parameters.begin(), placed.parameters.end());
  }
  double before = curve.knots.front();
  for (std::size_t i = 0; i <= points.size(); ++i) {
    const double here = i < points.size() ? placed.parameters[i] : curve.knots.back();
    if (!(before < here)) {
      const std::size_t at = std::min(i, points.size() - 1);
      refuse(curve.id, at, points[at],
             "the points are not in order along the edge, between its ends, or one is given twice");
    }
    before = here;
  }
  placed.points = std::move(points);
  return placed;
}

}  // namespace af2::geometry
