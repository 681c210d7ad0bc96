#include "dsl/program/zone_corners.h"

namespace af2::dsl {

std::vector<Point2> cornersAt(const ConvexPolygonZoneDef& zone, const AF2Binding& binding) {
  std::vector<Point2> corners;
  const double t = zone.fade(binding.level);
  for (const auto& corner : zone.corners()) {
    const auto p = corner.preferred->transformPoint(binding);
    const auto l = corner.limiting ? corner.limiting->transformPoint(binding) : p;
    if (!p || !l) return {};
    corners.push_back(corner.limiting ? t * *p + (1 - t) * *l : *p);
  }
  return corners;
}

}  // namespace af2::dsl
