// Boundary loops that touch: decides which edge follows which at a shared vertex.
#include <algorithm>
#include <cmath>

#include "engine/base/turn.h"
#include "engine/front/front.h"

namespace af2 {
namespace {

/// Increases with the angle from `from` counter-clockwise to `to`, seen along `normal`; in (0, 4].
double sweepAround(const Point3& normal, const Point3& from, const Point3& to) {
  const auto flat = [&](const Point3& d) { return d - dot(d, normal) * normal; };
  const double c = dot(flat(from), flat(to)), s = dot(normal, cross(from, to));
  return sweepOf(s, c);
}

}  // namespace

std::vector<PlaceId> Front::freeNeighbors(std::span<const PlaceId> places) const {
  const auto direction = [&](PlaceId from, PlaceId to) {
    return places_[to.value].point.position - places_[from.value].point.position;
  };
  const Point3 normal = places_[places[0].value].point.normal;
  std::vector<PlaceId> arriving;
  for (PlaceId p : places) {
    PlaceId best;
    double bestSweep = 0;
    for (PlaceId q : places) {
      const double angle = sweepAround(normal, direction(p, next(p)), direction(q, previous(q)));
      if (best.isNone() || angle < bestSweep) best = previous(q), bestSweep = angle;
    }
    if (std::count(arriving.begin(), arriving.end(), best) > 0) return {};
    arriving.push_back(best);
  }
  return arriving;
}

void Front::untangle() {
  std::vector<PlaceId> order;
  for (std::size_t i = 0; i < places_.size(); ++i)
    if (places_[i].level > 0 && hasEdgeBefore(PlaceId(i))) order.push_back(PlaceId(i));
  std::stable_sort(order.begin(), order.end(), [&](PlaceId p, PlaceId q) {
    return places_[p.value].vertex < places_[q.value].vertex;
  });
  for (std::size_t first = 0, last = 0; first < order.size(); first = last) {
    const VertexId vertex = places_[order[first].value].vertex;
    while (last < order.size() && places_[order[last].value].vertex == vertex) ++last;
    if (last - first < 2 || places_[order[first].value].point.normal == Point3{}) continue;
    const std::span<const PlaceId> places(order.data() + first, last - first);
    const std::vector<PlaceId> arriving = freeNeighbors(places);
    for (std::size_t i = 0; i < arriving.size(); ++i) link(arriving[i], places[i]);
  }
}

}  // namespace af2
