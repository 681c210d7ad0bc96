#include "engine/rule/element_metric.h"

#include <algorithm>
#include <cmath>

#include "engine/base/error.h"

namespace af2 {
namespace {

/// Perimeter^2 / area of the square.
constexpr double kSquarePerimeterRatio = 16;

}  // namespace

std::optional<double> ShapeSizeMetric::badness(std::span<const Point2> corners) const {
  const std::size_t n = corners.size();
  if (n == 3) {
    const double result = triangleBadness(corners[0], corners[1], corners[2]);
    return std::isfinite(result) ? std::optional(result) : std::nullopt;
  }
  double perimeter = 0, doubleArea = 0, size = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const Point2 p = corners[i], q = corners[i + 1 == n ? 0 : i + 1];
    const double edge = distance(p, q);
    perimeter += edge;
    doubleArea += cross(p - corners[0], q - corners[0]);
    size += edge + 1 / edge - 2;
  }
  const double result =
      weight_ * (perimeter * perimeter / (0.5 * doubleArea * kSquarePerimeterRatio) - 1) + size;
  if (!(doubleArea > 0) || !std::isfinite(result)) return std::nullopt;
  return result;
}

ScoreBound::ScoreBound(std::vector<double> bounds) : bounds_(std::move(bounds)) {
  if (bounds_.empty()) throw InputError("score bound: no bound is given");
}

bool ScoreBound::accepts(double score, int level) const {
  const auto last = static_cast<int>(bounds_.size()) - 1;
  return score < bounds_[static_cast<std::size_t>(std::clamp(level - 1, 0, last))];
}

}  // namespace af2
