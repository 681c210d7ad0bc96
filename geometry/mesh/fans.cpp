#include "geometry/mesh/fans.h"

#include <array>
#include <cmath>
#include <map>
#include <span>

#include "engine/mesh/element_shape.h"

namespace af2::geometry {

namespace {

bool isSound(const Mesh& mesh, const Element& quad) {
  std::array<const SurfacePoint*, 4> corners{};
  for (std::size_t i = 0; i < 4; ++i) corners[i] = &mesh.vertices[quad.corners[i].value];
  return std::isfinite(elementDistortion(corners));
}

/// The mesh has the vertices of the fan.
std::vector<Element> elementsOf(const std::vector<VertexId>& rim, VertexId tip, FanElements kind,
                                const Mesh& mesh) {
  std::vector<Element> elements;
  for (std::size_t i = 1; i < rim.size(); ++i) {
    if (kind == FanElements::Quads && i + 1 < rim.size()) {
      // The first diagonal, which divides the quadrilateral for other purposes, is that at the tip:
      // two quadrilaterals all around it have the corners of the other one in common.
      const Element quad{{rim[i], rim[i - 1], tip, rim[i + 1]}};
      if (isSound(mesh, quad)) {
        elements.push_back(quad);
        ++i;
        continue;
      }
    }
    elements.push_back({{rim[i], rim[i - 1], tip}});
  }
  return elements;
}

}  // namespace

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

void addFans(FaceBoundary& boundary, FanElements kind, ElementOrigin origin, Mesh& mesh) {
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
  for (const FaceBoundary::Fan& fan : boundary.fans) tips.push_back(fan.place);
  mesh.vertices.insert(mesh.vertices.begin() + first, tips.begin(), tips.end());
  for (const FaceBoundary::Fan& fan : boundary.fans) {
    const VertexId tip(boundary.points.size());
    boundary.points.push_back(fan.tip);
    std::vector<VertexId> rim;
    for (const VertexId v : fan.rim) rim.push_back(moved(v));
    for (const Element& element : elementsOf(rim, tip, kind, mesh)) {
      mesh.elements.push_back(element);
      mesh.origins.push_back(origin);
    }
  }
}

}  // namespace af2::geometry
