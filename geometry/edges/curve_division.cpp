#include "geometry/edges/curve_division.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace af2::geometry {

namespace {

std::size_t nearestSegments(double count) {
  return static_cast<std::size_t>(std::max(1.0, std::floor(count + 0.5)));
}

}  // namespace

void gradeAlong(std::span<const double> s, std::span<double> h, double growth) {
  for (std::size_t i = 1; i < h.size(); ++i)
    h[i] = std::min(h[i], h[i - 1] + growth * (s[i] - s[i - 1]));
  for (std::size_t i = h.size() - 1; i-- > 0;)
    h[i] = std::min(h[i], h[i + 1] + growth * (s[i + 1] - s[i]));
}

std::vector<double> segmentsAlong(std::span<const double> arcLength,
                                  std::span<const double> sizes) {
  std::vector<double> count(sizes.size(), 0);
  for (std::size_t i = 1; i < count.size(); ++i)
    count[i] = count[i - 1] + 2 * (arcLength[i] - arcLength[i - 1]) / (sizes[i - 1] + sizes[i]);
  return count;
}

std::vector<CurvePlace> equalShares(const std::vector<double>& count, double from, double to,
                                    std::size_t segments) {
  std::vector<CurvePlace> places;
  std::size_t cell = 1;
  for (std::size_t k = 1; k < segments; ++k) {
    const double target =
        from + (to - from) * static_cast<double>(k) / static_cast<double>(segments);
    while (cell + 1 < count.size() && count[cell] < target) ++cell;
    places.push_back({cell - 1, (target - count[cell - 1]) / (count[cell] - count[cell - 1])});
  }
  return places;
}

std::vector<CurvePlace> equalShares(const std::vector<double>& count, std::size_t segments) {
  return equalShares(count, 0, count.back(), segments);
}

CurvePlace placeAt(std::span<const double> arcLength, double length) {
  const auto found = std::lower_bound(arcLength.begin() + 1, arcLength.end() - 1, length);
  const auto cell = static_cast<std::size_t>(found - arcLength.begin()) - 1;
  return {cell, (length - arcLength[cell]) / (arcLength[cell + 1] - arcLength[cell])};
}

double turnAlong(std::span<const Point3> points) {
  double turn = 0;
  Point3 before = unit(points[1] - points[0]);
  for (std::size_t i = 2; i < points.size(); ++i) {
    const Point3 here = unit(points[i] - points[i - 1]);
    turn += distance(before, here);
    before = here;
  }
  const auto cells = static_cast<double>(points.size() - 1);
  return cells > 1 ? turn * cells / (cells - 1) : 0;  // each chord turns half as much at its ends
}

std::size_t wholeSegments(double count, double byTurn, double share) {
  return std::max(nearestSegments(count), fewestSegments(count, byTurn, share));
}

std::size_t fewestSegments(double count, double byTurn, double share) {
  constexpr double kStraight = 0.25;  // of the turn that a segment may have
  constexpr double kRounding = 0.01;
  if (byTurn < kStraight * static_cast<double>(nearestSegments(count))) return 1;
  const double enough = std::max(share * count, std::min(byTurn, count));
  return static_cast<std::size_t>(std::max(1.0, std::ceil(enough - kRounding)));
}

void gradeTogether(std::vector<SampledCurve>& curves, std::size_t points, double growth) {
  constexpr int kRounds = 3;  // a short curve passes a small size on to those beyond it
  std::vector<double> atPoint(points, 1e300);
  for (int round = 0; round < kRounds; ++round) {
    for (SampledCurve& curve : curves) {
      double &first = atPoint[curve.ends.first], &last = atPoint[curve.ends.last];
      curve.sizes.front() = std::min(curve.sizes.front(), first);
      curve.sizes.back() = std::min(curve.sizes.back(), last);
      gradeAlong(curve.arcLength, curve.sizes, growth);
      first = std::min(first, curve.sizes.front());
      last = std::min(last, curve.sizes.back());
    }
  }
}

std::vector<std::size_t> leastSegments(const std::vector<CurveEnds>& curves) {
  std::map<std::pair<std::size_t, std::size_t>, std::size_t> sameEnds;
  const auto key = [](CurveEnds ends) { return std::minmax({ends.first, ends.last}); };
  for (const CurveEnds ends : curves) ++sameEnds[key(ends)];
  std::vector<std::size_t> least;
  for (const CurveEnds ends : curves)
    least.push_back(ends.first == ends.last ? 3 : sameEnds[key(ends)] > 1 ? 2 : 1);
  return least;
}

}  // namespace af2::geometry
