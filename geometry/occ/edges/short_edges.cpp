#include "geometry/occ/edges/short_edges.h"

#include <algorithm>
#include <map>

namespace af2::geometry {

namespace {

/// Distance of the two points of an edge that are farthest from each other.
double extentOf(const DividedEdge& edge, const std::vector<Point3>& points) {
  double extent = 0;
  for (const std::uint32_t a : edge.points)
    for (const std::uint32_t b : edge.points)
      extent = std::max(extent, distance(points[a], points[b]));
  return extent;
}

/// Edges of the face by how large they are.
std::map<int, double> edgesNear(const ModelShape& model, int face, const DividedEdges& divided,
                                const std::vector<SizeSource>& places, double reach) {
  std::map<int, double> found;
  for (const auto& [id, use] : model.edgesOfFaces[static_cast<std::size_t>(face) - 1]) {
    const DividedEdge& edge = divided.edges[static_cast<std::size_t>(id) - 1];
    if (edge.points.empty()) continue;
    const Point3& end = divided.points[edge.points.front()];
    const bool isNear = places.empty() || std::ranges::any_of(places, [&](const SizeSource& place) {
                          return distance(place.position, end) <= reach;
                        });
    if (isNear) found[id] = extentOf(edge, divided.points);
  }
  return found;
}

}  // namespace

std::vector<CollapsedEdges> shortEdgesNear(const ModelShape& model, int face,
                                           const DividedEdges& divided,
                                           const std::vector<SizeSource>& places, double wanted) {
  const std::map<int, double> near = edgesNear(model, face, divided, places, wanted);
  std::vector<CollapsedEdges> steps;
  for (const double share : {0.03, 0.1, 1.0 / 3}) {
    CollapsedEdges edges;
    for (const auto& [edge, extent] : near)
      if (extent <= share * wanted) edges[edge] = share * wanted;
    if (edges.size() > (steps.empty() ? 0 : steps.back().size())) steps.push_back(edges);
  }
  return steps;
}

}  // namespace af2::geometry
