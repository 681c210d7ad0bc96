#include "engine/optimize/corner_cost.h"

namespace af2 {
namespace {

/// The derivatives of the logarithm of a function.
struct LogSlope {
  Point2 first;
  double xx = 0, xy = 0, yy = 0;

  LogSlope& add(double factor, const LogSlope& other) {
    first = first + factor * other.first;
    xx += factor * other.xx;
    xy += factor * other.xy;
    yy += factor * other.yy;
    return *this;
  }
};

/// Of the squared length of a side: its second derivatives are 2 by^2 times the identity.
LogSlope ofSquare(Point2 side, double by) {
  const double inverse = 1 / dot(side, side);
  const Point2 g = (2 * by * inverse) * side;
  const double twice = 2 * by * by * inverse;
  return {g, twice - g.x * g.x, -g.x * g.y, twice - g.y * g.y};
}

/// Of the cross product of the sides, which is linear in x.
LogSlope ofArea(Point2 e, Point2 f, double byE, double byF) {
  const double inverse = 1 / cross(e, f);
  const Point2 g{inverse * (byE * f.y - byF * e.y), inverse * (byF * e.x - byE * f.x)};
  return {g, -g.x * g.x, -g.x * g.y, -g.y * g.y};
}

void add(CornerSum& sum, double value, const LogSlope& log) {
  sum.value += value;
  sum.slope = sum.slope + value * log.first;
  sum.xx += value * (log.xx + log.first.x * log.first.x);
  sum.xy += value * (log.xy + log.first.x * log.first.y);
  sum.yy += value * (log.yy + log.first.y * log.first.y);
}

}  // namespace

void CornerShape::addTo(CornerSum& sum, double byAhead, double byBehind) const {
  const double ee = dot(ahead, ahead), ff = dot(behind, behind), c = area();
  const LogSlope logE = ofSquare(ahead, byAhead), logF = ofSquare(behind, byBehind);
  LogSlope product = logE, ratio = logE, inverseRatio = logF;
  product.add(1, logF).add(-2, ofArea(ahead, behind, byAhead, byBehind));
  ratio.add(-1, logF);
  inverseRatio.add(-1, logE);
  constexpr double kQuarter = 0.25 * kSides;
  add(sum, ee * ff / (c * c), product);
  add(sum, kQuarter * ee / ff, ratio);
  add(sum, kQuarter * ff / ee, inverseRatio);
  sum.value += 2 * kQuarter;
}

}  // namespace af2
