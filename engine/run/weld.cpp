#include "engine/run/weld.h"

#include <algorithm>

#include "engine/base/segment.h"

namespace af2 {
namespace {

constexpr double kLeastJacobian = 0.1;
/// How far the edges of the two vertices may reach, in lengths of the longest of them.
constexpr double kReach = 2.5;

class WeldTest {
 public:
  WeldTest(const Advance& advance, const StepChart& chart, const Weld& weld)
      : advance_(advance), chart_(chart), weld_(weld), to_(chart.positionOf(weld.point)) {
    places_ = weld.places;
    places_.insert(places_.end(), {weld.first, weld.last});
  }

  bool passes() const {
    return !haveCommonNeighbour() && keepsElements(weld_.from) && keepsElements(weld_.into) &&
           keepsFront();
  }

 private:
  const Front& front() const { return advance_.front; }
  VertexId vertexAt(PlaceId place) const { return front()[place].vertex; }
  VertexId middle() const { return vertexAt(front().next(weld_.first)); }
  Point2 at(VertexId v) const { return chart_.positionOf(advance_.mesh.vertices[v.value]); }

  enum class Within { Sides, Elements };

  /// Along the front, and along sides of elements or across elements, too; sorted. Where an element
  /// has both vertices, one is a neighbour of the other within it.
  std::vector<VertexId> neighboursOf(VertexId v, Within within) const {
    std::vector<VertexId> all;
    advance_.elements.forEachAt(v, [&](std::size_t e, std::size_t c) {
      const Element& element = advance_.mesh.elements[e];
      const auto n = static_cast<std::size_t>(element.size());
      for (std::size_t i = 1; i < n; ++i)
        if (within == Within::Elements || i == 1 || i + 1 == n)
          all.push_back(element.corners[(c + i) % n]);
    });
    for (const PlaceId place : places_)
      if (vertexAt(place) == v)
        for (const PlaceId next : {front().next(place), front().previous(place)})
          all.push_back(vertexAt(next));
    std::ranges::sort(all);
    return all;
  }

  bool haveCommonNeighbour() const {
    if (std::ranges::binary_search(neighboursOf(weld_.from, Within::Elements), weld_.into))
      return true;
    const std::vector<VertexId> ofInto = neighboursOf(weld_.into, Within::Sides);
    return std::ranges::any_of(neighboursOf(weld_.from, Within::Sides), [&](VertexId v) {
      return v != middle() && std::ranges::binary_search(ofInto, v);
    });
  }

  bool keepsElements(VertexId v) const {
    bool areSound = true;
    advance_.elements.forEachAt(v, [&](std::size_t e, std::size_t) {
      const Element& element = advance_.mesh.elements[e];
      areSound =
          areSound && scaledJacobianIn(chart_, advance_.mesh, element, v, to_) >= kLeastJacobian;
    });
    return areSound;
  }

  /// Whether no edge that moves passes over a vertex or crosses an edge of the rest of the front.
  bool keepsFront() const {
    double longest = 0;
    for (const PlaceId place : places_)
      longest = std::max(
          {longest, front().edgeLength(place), front().edgeLength(front().previous(place))});
    const std::vector<PlaceId> near = advance_.edgesNear(weld_.first, kReach * longest);
    for (const PlaceId place : places_)
      for (const PlaceId end : {front().next(place), front().previous(place)}) {
        const VertexId far = vertexAt(end);
        if (far != middle() && !isFree(vertexAt(place), far, near)) return false;
      }
    return true;
  }

  bool isFree(VertexId moved, VertexId far, const std::vector<PlaceId>& near) const {
    const Point2 from = at(moved), end = at(far);
    const auto isOne = [&](VertexId v) {
      return v == weld_.from || v == weld_.into || v == far || v == middle();
    };
    for (const PlaceId edge : near) {
      const VertexId start = vertexAt(edge);
      if (!isOne(start) && isInside(at(start), from, to_, end)) return false;
      if (!front().hasEdge(edge)) continue;
      const VertexId other = vertexAt(front().next(edge));
      if (!isOne(start) && !isOne(other) && doCross(to_, end, at(start), at(other))) return false;
    }
    return true;
  }

  static bool isInside(Point2 p, Point2 a, Point2 b, Point2 c) {
    const double ab = cross(b - a, p - a), bc = cross(c - b, p - b), ca = cross(a - c, p - c);
    return (ab >= 0 && bc >= 0 && ca >= 0) || (ab <= 0 && bc <= 0 && ca <= 0);
  }

  const Advance& advance_;
  const StepChart& chart_;
  const Weld& weld_;
  Point2 to_;
  std::vector<PlaceId> places_;  ///< all places of the two vertices
};

std::vector<PlaceId> otherPlaces(const Advance& advance, PlaceId first, PlaceId last) {
  std::vector<PlaceId> others;
  for (const PlaceId end : {first, last})
    for (const PlaceId place : advance.placesOf(end))
      if (place != first && place != last) others.push_back(place);
  return others;
}

}  // namespace

std::optional<Weld> planWeld(const Advance& advance, const StepChart& chart, PlaceId first,
                             bool takesLast, const SurfacePoint& point) {
  constexpr int kShortestLoop = 5;
  const Front& front = advance.front;
  const PlaceId last = front.next(front.next(first));
  const bool isFirstFixed = advance.isFixed(front[first].vertex);
  const bool isLastFixed = advance.isFixed(front[last].vertex);
  if (isFirstFixed && isLastFixed) return std::nullopt;
  if (front[first].vertex == front[last].vertex || front.loopSize(first) < kShortestLoop)
    return std::nullopt;
  const PlaceId kept = isLastFixed || (takesLast && !isFirstFixed) ? last : first;
  Weld weld;
  weld.first = first;
  weld.last = last;
  weld.into = front[kept].vertex;
  weld.from = front[kept == last ? first : last].vertex;
  weld.point = isFirstFixed || isLastFixed ? front[kept].point : point;
  weld.places = otherPlaces(advance, first, last);
  if (!WeldTest(advance, chart, weld).passes()) return std::nullopt;
  return weld;
}

void apply(Advance& advance, const Weld& weld, Front::Change& change) {
  Front& front = advance.front;
  std::vector<PlaceId> places = weld.places;
  places.push_back(weld.last);
  const auto forEachEdge = [&](const auto& visit) {
    for (const PlaceId place : places)
      for (const PlaceId edge : {place, front.previous(place)})
        if (front.hasEdge(edge)) visit(edge);
  };
  forEachEdge([&](PlaceId edge) { advance.index.erase(edge); });
  advance.index.erase(weld.first);
  advance.index.erase(front.previous(weld.first));
  front.weld(weld.first, weld.last, weld.into, weld.point, change);
  for (const PlaceId place : weld.places) {
    front[place].vertex = weld.into;
    front[place].point = weld.point;
  }
  advance.mesh.vertices[weld.into.value] = weld.point;
  advance.elements.forEachAt(weld.from, [&](std::size_t e, std::size_t c) {
    advance.mesh.elements[e].corners[c] = weld.into;
  });
  advance.elements.give(weld.from, weld.into);
  forEachEdge([&](PlaceId edge) {
    advance.index.erase(edge);  // an edge between two of the places comes twice
    advance.index.insert(front, edge);
    advance.queue.renew(front, edge);
  });
}

}  // namespace af2
