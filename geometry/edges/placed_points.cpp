#include "geometry/edges/placed_points.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "engine/base/error.h"
#include "engine/base/place_text.h"

namespace af2::geometry {
namespace {

[[noreturn]] void refuse(int edge, std::size_t index, const Point3& p, const std::string& fault) {
  throw InputError("point " + std::to_string(index + 1) + " given for edge " +
                   std::to_string(edge) + ", " + textOf(p) + ": " + fault);
}

}  // namespace

double toleranceOfPoints(double length, std::size_t points) {
  constexpr double kShareOfSegment = 0.01;
  return kShareOfSegment * length / static_cast<double>(points + 1);
}

PlacedPoints placePoints(int edge, std::vector<Point3> points, const PlacedRange& range,
                         const std::function<CurveFoot(const Point3&)>& footOf) {
  PlacedPoints placed;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const CurveFoot foot = footOf(points[i]);
    if (!(foot.distance <= range.tolerance))
      refuse(edge, i, points[i],
             std::isfinite(foot.distance)
                 ? "it is " + textOf(foot.distance) + " away from the edge"
                 : "it is beyond the ends of the edge; give only points between them");
    placed.parameters.push_back(foot.parameter);
  }
  if (points.size() > 1 && placed.parameters.front() > placed.parameters.back()) {
    std::ranges::reverse(points);
    std::ranges::reverse(placed.parameters);
  }
  placed.parameters.insert(placed.parameters.begin(), range.first);
  placed.parameters.push_back(range.last);
  for (std::size_t i = 0; i <= points.size() && !points.empty(); ++i) {
    if (placed.parameters[i] < placed.parameters[i + 1]) continue;
    const std::size_t at = std::min(i, points.size() - 1);
    refuse(edge, at, points[at],
           "the points are not in order along the edge, between its ends, or one is given twice");
  }
  placed.points = std::move(points);
  return placed;
}

void requireSegments(int edge, std::size_t points, std::size_t least) {
  if (points + 1 >= least) return;
  throw InputError("the points given for edge " + std::to_string(edge) + " make " +
                   std::to_string(points + 1) + " segments; it needs at least " +
                   std::to_string(least) + ", or it would share a segment");
}

}  // namespace af2::geometry
