#include "geometry/mesh/fans.h"

#include <map>

namespace af2::geometry {

double areaOfFans(const FaceBoundary& boundary) {
  if (boundary.fans.empty()) return 0;
  std::map<VertexId, Point3> positions;
  for (const auto& loop : boundary.input.loops)
    for (const BoundaryCorner& corner : loop) positions[corner.vertex] = corner.point.position;
  double area = 0;
  for (const FaceBoundary::Fan& fan : boundary.fans)
    for (std::size_t i = 1; i < fan.rim.size(); ++i)
      area += length(cross(positions[fan.rim[i - 1]] - fan.place.position,
                           positions[fan.rim[i]] - fan.place.position)) /
              2;
  return area;
}

void addFans(FaceBoundary& boundary, ElementOrigin origin, Mesh& mesh) {
  if (boundary.fans.empty()) return;
  const auto first = static_cast<std::uint32_t>(boundary.points.size());
  const auto count = static_cast<std::uint32_t>(boundary.fans.size());
  const auto moved = [&](VertexId v) { return v.value < first ? v : VertexId(v.value + count); };
  for (Element& element : mesh.elements)
    for (int i = 0; i < element.size(); ++i) {
      VertexId& v = element.corners[static_cast<std::size_t>(i)];
      v = moved(v);
    }
  std::vector<SurfacePoint> tips;
  for (const FaceBoundary::Fan& fan : boundary.fans) {
    const VertexId tip(boundary.points.size());
    boundary.points.push_back(fan.tip);
    tips.push_back(fan.place);
    for (std::size_t i = 1; i < fan.rim.size(); ++i) {
      mesh.elements.push_back({{moved(fan.rim[i]), moved(fan.rim[i - 1]), tip}});
      mesh.origins.push_back(origin);
    }
  }
  mesh.vertices.insert(mesh.vertices.begin() + first, tips.begin(), tips.end());
}

}  // namespace af2::geometry
