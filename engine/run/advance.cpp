#include "engine/run/advance.h"

#include <algorithm>
#include <array>

#include "engine/mesh/element_measures.h"

namespace af2 {

std::vector<PlaceId> Advance::edgesNear(PlaceId place, double reach) const {
  const Point3 center = front[place].point.position, r{reach, reach, reach};
  std::vector<PlaceId> found;
  const FrontIndex::Collected collected = index.collectNear({center - r, center + r}, found);
  found.resize(collected.count);
  std::ranges::sort(found);
  return found;
}

std::vector<PlaceId> Advance::placesOf(PlaceId place) const {
  std::vector<PlaceId> places{place};
  const VertexId vertex = front[place].vertex;
  for (const PlaceId id : edgesNear(place, 0))
    for (const PlaceId end : {id, front.next(id)})
      if (front[end].vertex == vertex) places.push_back(end);
  std::ranges::sort(places);
  places.erase(std::unique(places.begin(), places.end()), places.end());
  return places;
}

void Advance::move(VertexId v, std::span<const PlaceId> places, const SurfacePoint& to) {
  mesh.vertices[v.value] = to;
  const auto forEachEdge = [&](const auto& visit) {
    for (const PlaceId place : places) {
      if (front.hasEdge(place)) visit(place);
      if (front.hasEdgeBefore(place)) visit(front.previous(place));
    }
  };
  forEachEdge([&](PlaceId edge) { index.erase(edge); });
  for (const PlaceId place : places) front[place].point = to;
  forEachEdge([&](PlaceId edge) {
    index.erase(edge);  // an edge between two of the places comes twice
    index.insert(front, edge);
  });
  for (const PlaceId place : places)
    for (const PlaceId edge :
         {front.previous(front.previous(place)), front.previous(place), place, front.next(place)})
      queue.renew(front, edge);
}

StepChart Advance::chartAt(PlaceId place, ChartSlot& slot) const {
  const Place& from = front[place];
  return {maker.makeLocalTransformIn(slot, from.point, front[from.next].point, from.size),
          from.size};
}

double scaledJacobianIn(const StepChart& chart, const Mesh& mesh, const Element& element,
                        VertexId moved, Point2 to) {
  std::array<Point2, 4> corners;
  const std::size_t n = static_cast<std::size_t>(element.size());
  for (std::size_t i = 0; i < n; ++i)
    corners[i] = element.corners[i] == moved
                     ? to
                     : chart.positionOf(mesh.vertices[element.corners[i].value]);
  return scaledJacobian({corners.data(), n});
}

}  // namespace af2
