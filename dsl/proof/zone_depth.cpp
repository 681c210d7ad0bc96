#include "dsl/proof/zone_depth.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "dsl/shapes/shape.h"

namespace af2::dsl {
namespace {

constexpr double kSag = 1e-4;

double distanceToSide(Point2 p, Point2 a, Point2 b) {
  const Point2 along = b - a;
  const double size = dot(along, along);
  const double t = size > 0 ? std::clamp(dot(p - a, along) / size, 0.0, 1.0) : 0;
  return distance(p, a + t * along);
}

}  // namespace

bool isConvexPolygon(const AF2FreeZone& zone) {
  return dynamic_cast<const ConvexPolygonZone*>(&zone) != nullptr;
}

std::optional<Point2> unseenPlace(const AF2FreeZone& zone, std::span<const Point2> element) {
  constexpr int kSteps = 8;
  constexpr double kInwards = 1e-5;  // share of the way to the middle; exceeds rounding errors
  const std::size_t n = element.size();
  Point2 middle{};
  for (const Point2 corner : element) middle = middle + (1.0 / static_cast<double>(n)) * corner;
  const int steps = isConvexPolygon(zone) ? 1 : kSteps;
  for (int s = 0; s < steps; ++s)
    for (std::size_t i = 0; i < n; ++i) {
      const Point2 edge = element[(i + 1) % n] - element[i];
      const Point2 p = element[i] + (static_cast<double>(s) / steps) * edge;
      const Point2 inner = p + kInwards * (middle - p);
      if (!zone.contains(inner, ZoneBoundary::Counts)) return inner;
    }
  return std::nullopt;
}

MeasuredZone::MeasuredZone(const AF2FreeZone& zone) : zone_(zone) {}

const std::vector<std::vector<Point2>>& MeasuredZone::outlineLoops() const {
  if (!loops_) loops_ = outline(zone_, kSag);
  return *loops_;
}

double MeasuredZone::depthOutside(Point2 point) const {
  if (zone_.contains(point, ZoneBoundary::Counts)) return 0;
  double depth = std::numeric_limits<double>::infinity();
  for (const auto& loop : outlineLoops())
    for (std::size_t i = 0, j = loop.size() - 1; i < loop.size(); j = i++)
      depth = std::min(depth, distanceToSide(point, loop[j], loop[i]));
  return depth;
}

}  // namespace af2::dsl
