#include "engine/step/zone_polygon.h"

#include <algorithm>

namespace af2 {
namespace {

/// Let u be 2^-53. The number of a side d from p to q is n . x + c with n = (-d.y, d.x) and c = d.y
/// p.x - d.x p.y. Each of its four products is rounded at most five times, so the error is below
/// 5.1 u (|d.x| + |d.y|) (|x| + |y| + |p.x| + |p.y|). Here |p.x| + |p.y| is at most the reach,
/// |d.x| + |d.y| at most twice that; the factor 16 u also covers the rounding of the bound itself.
constexpr double kErrorBound = 1.7763568394002505e-15;
double least(const std::array<double, 8>& values) {
  std::array<double, 4> four;
  for (std::size_t k = 0; k < 4; ++k) four[k] = std::min(values[k], values[k + 4]);
  return std::min(std::min(four[0], four[2]), std::min(four[1], four[3]));
}

double largest(const std::array<double, 8>& values) {
  std::array<double, 4> four;
  for (std::size_t k = 0; k < 4; ++k) four[k] = std::max(values[k], values[k + 4]);
  return std::max(std::max(four[0], four[2]), std::max(four[1], four[3]));
}

}  // namespace

bool ZonePolygon::make(const FastZone& zone, int level, const Point2* matched) {
  const AffineBatch& batch = zone.at(level);
  double x[kSides], y[kSides];
  batch.evaluate(matched, x, y);
  count_ = static_cast<std::size_t>(batch.count);
  for (std::size_t k = 0; k < count_; ++k) corners_[k] = {x[k], y[k]};
  drawSides();
  if (isPlainlyConvex()) return true;
  count_ = static_cast<std::size_t>(convex_polygon::normalize(corners_.data(), batch.count));
  drawSides();
  return count_ > 0;
}

bool ZonePolygon::makeOf(std::span<const std::int8_t> corners, const Point2* vertices) {
  count_ = corners.size();
  for (std::size_t k = 0; k < count_; ++k)
    corners_[k] = vertices[static_cast<std::size_t>(corners[k])];
  drawSides();
  return isPlainlyConvex();
}

void ZonePolygon::drawSides() {
  for (std::size_t k = count_; k <= kSides; ++k) corners_[k] = corners_[0];
  Values x, y;
  for (std::size_t k = 0; k < kSides; ++k) {
    const Point2 p = corners_[k], d = corners_[k + 1] - p;
    x[k] = p.x;
    y[k] = p.y;
    sideX_[k] = d.x;
    sideY_[k] = d.y;
  }
  for (std::size_t k = 0; k < kSides; ++k) {
    normalX_[k] = -sideY_[k];
    normalY_[k] = sideX_[k];
    constant_[k] = sideY_[k] * x[k] - sideX_[k] * y[k];
  }
  box_ = {{least(x), least(y)}, {largest(x), largest(y)}};
  reach_ = std::max(std::abs(box_.low.x), std::abs(box_.high.x)) +
           std::max(std::abs(box_.low.y), std::abs(box_.high.y));
  error_ = kErrorBound * reach_;
}

/// Whether the filter of `orientation` alone proves that all corners turn left, once around.
bool ZonePolygon::isPlainlyConvex() const {
  bool allTurnLeft = count_ >= 3;
  int turnsDown = 0;
  std::size_t in = count_ - 1;
  for (std::size_t out = 0; out < count_; in = out++) {
    allTurnLeft =
        allTurnLeft & detail::isPlainlyLeft(sideX_[in] * sideY_[out], sideY_[in] * sideX_[out]);
    turnsDown += (sideY_[in] > 0) & !(sideY_[out] > 0);
  }
  return allTurnLeft && turnsDown == 1;
}

bool ZonePolygon::isBeyond(std::size_t k, Point2 point, double value, double error,
                           ZoneBoundary boundary) const {
  if (value < -error) return true;
  if (value > error) return false;
  const Turn turn = orientation(corners_[k], corners_[k + 1], point);
  return turn == Turn::Right || (turn == Turn::Straight && boundary == ZoneBoundary::Ignored);
}

bool ZonePolygon::contains(Point2 point, ZoneBoundary boundary) const {
  Values values;
  evaluateSides(point, values);
  const double error = errorAt(std::abs(point.x), std::abs(point.y));
  if (least(values) < -error) return false;
  for (std::size_t k = 0; k < count_; ++k)
    if (isBeyond(k, point, values[k], error, boundary)) return false;
  return true;
}

bool ZonePolygon::meets(Point2 from, Point2 to, ZoneBoundary boundary) const {
  if (from == to) return contains(from, boundary);
  Values atFrom, atTo, larger;
  evaluateSides(from, atFrom);
  evaluateSides(to, atTo);
  for (std::size_t k = 0; k < kSides; ++k) larger[k] = std::max(atFrom[k], atTo[k]);
  const double error = errorAt(std::max(std::abs(from.x), std::abs(to.x)),
                               std::max(std::abs(from.y), std::abs(to.y)));
  if (least(larger) < -error) return false;
  for (std::size_t k = 0; k < count_; ++k)
    if (larger[k] <= error && isBeyond(k, from, atFrom[k], error, boundary) &&
        isBeyond(k, to, atTo[k], error, boundary))
      return false;
  return convex_polygon::meetsLine(corners(), from, to, boundary);
}

}  // namespace af2
