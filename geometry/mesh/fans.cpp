#include "geometry/mesh/fans.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <span>
#include <utility>
#include <vector>

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

/// The numbers of vertices when the tips have been inserted behind those of the boundary.
struct WithTips {
  std::uint32_t first, count;

  explicit WithTips(const FaceBoundary& boundary, std::size_t points)
      : first(static_cast<std::uint32_t>(points)),
        count(static_cast<std::uint32_t>(boundary.fans.size())) {}
  VertexId moved(VertexId v) const { return v.value < first ? v : VertexId(v.value + count); }
  VertexId tip(std::size_t fan) const { return VertexId(first + fan); }
};

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
  const WithTips numbers(boundary, boundary.points.size());
  for (Element& element : mesh.elements)
    for (int i = 0; i < element.size(); ++i) {
      VertexId& v = element.corners[static_cast<std::size_t>(i)];
      v = numbers.moved(v);
    }
  std::vector<SurfacePoint> tips;
  for (const FaceBoundary::Fan& fan : boundary.fans) tips.push_back(fan.place);
  mesh.vertices.insert(mesh.vertices.begin() + numbers.first, tips.begin(), tips.end());
  for (const FaceBoundary::Fan& fan : boundary.fans) {
    const VertexId tip(boundary.points.size());
    boundary.points.push_back(fan.tip);
    std::vector<VertexId> rim;
    for (const VertexId v : fan.rim) rim.push_back(numbers.moved(v));
    for (const Element& element : elementsOf(rim, tip, kind, mesh)) {
      mesh.elements.push_back(element);
      mesh.origins.push_back(origin);
    }
  }
}

MeshBoundary boundaryWithFans(const FaceBoundary& boundary) {
  MeshBoundary result = boundaryOf(boundary.input);
  const WithTips numbers(boundary, boundary.points.size() - boundary.fans.size());
  for (std::size_t i = 0; i < boundary.fans.size(); ++i) {
    const std::vector<VertexId>& rim = boundary.fans[i].rim;
    for (std::size_t k = 1; k < rim.size(); ++k)
      std::erase(result.edges, std::pair(rim[k - 1], rim[k]));
  }
  for (auto& [from, to] : result.edges) {
    from = numbers.moved(from);
    to = numbers.moved(to);
  }
  for (std::size_t i = 0; i < boundary.fans.size(); ++i) {
    const std::vector<VertexId>& rim = boundary.fans[i].rim;
    result.edges.emplace_back(numbers.moved(rim.front()), numbers.tip(i));
    result.edges.emplace_back(numbers.tip(i), numbers.moved(rim.back()));
  }
  std::ranges::sort(result.edges);
  result.fixedCount = boundary.points.size();
  return result;
}

}  // namespace af2::geometry
