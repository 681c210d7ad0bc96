#include "engine/step/open_places.h"

#include <algorithm>
#include <utility>

#include "engine/base/predicates.h"

namespace af2 {
namespace {

/// The free directions at a place: counter-clockwise from the next to the previous front vertex,
/// both included.
struct Sector {
  Point2 center, next, previous;

  bool contains(Point2 d) const {
    if (d == next || d == previous) return true;
    const bool leftOfNext = orientation(center, next, d) != Turn::Right;
    const bool rightOfPrevious = orientation(center, previous, d) != Turn::Left;
    if (leftOfNext && rightOfPrevious) return true;
    switch (orientation(center, next, previous)) {
      case Turn::Left:
        return false;
      case Turn::Right:
        return leftOfNext || rightOfPrevious;
      case Turn::Straight:
        break;
    }
    return leftOfNext || dot(next - center, previous - center) > 0;
  }

  /// Whether a new edge may go there: into the free directions, and not along a front edge to its
  /// own end or beyond. What lies between the two would have no area, and rounding would decide
  /// which side of it is free.
  bool isOpenTo(Point2 d) const {
    return contains(d) && !runsAlong(next, d) && !runsAlong(previous, d);
  }

 private:
  bool runsAlong(Point2 end, Point2 d) const {
    constexpr double kMinSine = 1e-9;
    const Point2 one = end - center, other = d - center;
    const double turned = cross(one, other);
    return d != end && dot(one, other) > 0 &&
           turned * turned <= kMinSine * kMinSine * dot(one, one) * dot(other, other);
  }
};

Point2 positionOf(const StepView& view, PlaceId id) {
  for (const DrawnBase::Corner* corner : {&view.drawn.a, &view.drawn.b})
    if (corner->place == id) return corner->point.position;
  return view.chart.positionOf(view.front[id].point);
}

bool placeIsOpenTo(const StepView& view, PlaceId id, Point2 center, Point2 d1, Point2 d2) {
  const Place& place = view.front[id];
  // At an isolated vertex and at the end of an open chain all directions are free.
  if (place.level <= 0 || !view.front.hasEdge(place.previous)) return true;
  const Sector sector{center, positionOf(view, place.next), positionOf(view, place.previous)};
  return sector.isOpenTo(d1) && sector.isOpenTo(d2);
}

/// The same for the ends a and b of the base, whose chart positions are already known.
bool baseIsOpenTo(const StepView& view, const Match& match, Point2 first, Point2 last) {
  const Point2 a = match.points[0], b = match.points[1];
  const DrawnBase::Corner &before = view.drawn.before, &after = view.drawn.after;
  return (!view.front.hasEdge(before.place) ||
          Sector{a, b, before.point.position}.isOpenTo(first)) &&
         (!view.front.hasEdge(match.places[1]) ||
          Sector{b, after.point.position, a}.isOpenTo(last));
}

/// A vertex may have several places on the front. Returns the one whose free sector holds the new
/// elements; none if they would cover what is already meshed.
PlaceId openPlace(const StepView& view, PlaceId matched, Point2 center, Point2 d1, Point2 d2) {
  if (placeIsOpenTo(view, matched, center, d1, d2)) return matched;
  const VertexId id = view.front[matched].vertex;
  for (const Neighborhood::Edge& edge : view.near.edges()) {
    const PlaceId other = edge.place;
    if (other != matched && view.front[other].vertex == id &&
        placeIsOpenTo(view, other, center, d1, d2))
      return other;
  }
  return {};
}

/// Whether the free directions to the left of the path before -> center -> after include everything
/// at a place that is not free.
bool goesAround(const StepView& view, PlaceId id, Point2 center, Point2 before, Point2 after) {
  const Sector left{center, after, before};
  const Place& place = view.front[id];
  return left.contains(positionOf(view, place.next)) &&
         left.contains(positionOf(view, place.previous));
}

/// Where new elements share only a vertex, the walk visits it more than once. Each visit between
/// two elements cuts off free space at the place; one visit alone passes the rest of the front
/// there, and the vertex is joined at that visit. Returns false if that visit cannot be determined.
bool joinOnce(const StepView& view, const CompiledRule& rule, const Match& match,
              std::vector<PlaceId>& joined) {
  const auto& walk = rule.rule->replacement();
  const auto at = [&](int v) { return match.points[static_cast<std::size_t>(v)]; };
  for (int v = 0; v < rule.matchedCount; ++v) {
    const bool isEnd = v < 2;  // a and b: the ends of the walk
    const auto passes = std::ranges::count(walk, v);
    if (passes + isEnd < 2) continue;
    PlaceId last;  // where the vertex is joined
    for (std::size_t i = 0; i < walk.size(); ++i) {
      if (walk[i] != v) continue;
      const PlaceId place = std::exchange(joined[i], PlaceId());
      const bool isLoose = view.front[place].level <= 0;
      const Point2 before = at(i == 0 ? 0 : walk[i - 1]);
      const Point2 after = at(i + 1 == walk.size() ? 1 : walk[i + 1]);
      if (isLoose ? !last.isNone() : !goesAround(view, place, at(v), before, after)) continue;
      if (!last.isNone()) return false;
      joined[i] = last = place;
    }
    if (last.isNone() && !isEnd) return false;
  }
  return true;
}

}  // namespace

bool findOpenPlaces(const StepView& view, const CompiledRule& rule, const Match& match,
                    OpenPlaces& open) {
  open.places.assign(match.places.begin(), match.places.begin() + rule.matchedCount);
  open.joined.clear();
  const auto& walk = rule.rule->replacement();
  const auto at = [&](int v) { return match.points[static_cast<std::size_t>(v)]; };
  if (!baseIsOpenTo(view, match, at(walk.front()), at(walk.back()))) return false;
  for (std::size_t i = 0; i < walk.size(); ++i) {
    PlaceId place;
    if (walk[i] < rule.matchedCount) {
      const auto v = static_cast<std::size_t>(walk[i]);
      const Point2 before = at(i == 0 ? 0 : walk[i - 1]);
      const Point2 after = at(i + 1 == walk.size() ? 1 : walk[i + 1]);
      place = open.places[v] = openPlace(view, open.places[v], at(walk[i]), before, after);
      if (place.isNone()) return false;
    }
    open.joined.push_back(place);
  }
  return !rule.touchesItself || joinOnce(view, rule, match, open.joined);
}

}  // namespace af2
