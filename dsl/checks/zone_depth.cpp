#include "dsl/checks/zone_depth.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "dsl/shapes/shape.h"

namespace af2::dsl {
namespace {

constexpr double kSag = 1e-6;

double distanceToSide(Point2 p, Point2 a, Point2 b) {
  const Point2 along = b - a;
  const double size = dot(along, along);
  const double t = size > 0 ? std::clamp(dot(p - a, along) / size, 0.0, 1.0) : 0;
  return distance(p, a + t * along);
}

}  // namespace

MeasuredZone::MeasuredZone(const AF2FreeZone& zone)
    : zone_(zone), isConvex_(dynamic_cast<const ConvexPolygonZone*>(&zone) != nullptr) {}

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

MeasuredZone::Poke MeasuredZone::pokeOf(std::span<const Point2> corners) const {
  constexpr int kSteps = 12;
  const int steps = isConvex_ ? 1 : kSteps;
  Poke worst;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Point2 from = corners[i], to = corners[(i + 1) % corners.size()];
    for (int s = 0; s < steps; ++s) {
      const Point2 p = from + (static_cast<double>(s) / steps) * (to - from);
      const double depth = depthOutside(p);
      if (depth > worst.depth) worst = {depth, p};
    }
  }
  return worst;
}

}  // namespace af2::dsl
