#include "engine/step/surroundings.h"

#include <algorithm>
#include <cmath>

#include "engine/base/segment.h"

namespace af2 {
double FrontSurroundings::size(Point2 point) const {
  const auto onSurface = view_.chart.lift(point);
  return onSurface ? size_.sizeAt(*onSurface) / view_.chart.unit() : 1;
}

/// In the chart. What belongs to the base edge has been drawn already.
Point2 FrontSurroundings::positionOf(PlaceId place) const {
  for (const DrawnBase::Corner* corner :
       {&view_.drawn.before, &view_.drawn.a, &view_.drawn.b, &view_.drawn.after})
    if (corner->place == place) return corner->point.position;
  return view_.chart.positionOf(view_.front[place].point);
}

bool FrontSurroundings::hasOnePlace(int vertex) const {
  const RuleDefinition& rule = rule_.definition();
  return rule.vertices[static_cast<std::size_t>(vertex)].near ||
         std::ranges::any_of(
             rule.edges, [&](const PatternEdge& e) { return e.from == vertex || e.to == vertex; });
}

std::optional<double> FrontSurroundings::turn(int vertex) const {
  const PlaceId place = idOf(vertex);
  if (!hasOnePlace(vertex) || !view_.front.hasEdge(place) || !view_.front.hasEdgeBefore(place))
    return std::nullopt;
  return view_.front.turn(place);
}

/// An open chain, of which tests of rules consist, is taken to run on straight; at an isolated
/// vertex, opposite to the base edge.
std::optional<Point2> FrontSurroundings::before(int vertex) const {
  const PlaceId place = idOf(vertex);
  if (!hasOnePlace(vertex)) return std::nullopt;
  if (view_.front.hasEdgeBefore(place)) return positionOf(view_.front.previous(place));
  if (view_.front.hasEdge(place))
    return 2 * positionOf(place) - positionOf(view_.front.next(place));
  return positionOf(place) + match_.points[1];
}

std::optional<Point2> FrontSurroundings::after(int vertex) const {
  const PlaceId place = idOf(vertex);
  if (!hasOnePlace(vertex)) return std::nullopt;
  if (view_.front.hasEdge(place)) return positionOf(view_.front.next(place));
  if (view_.front.hasEdgeBefore(place))
    return 2 * positionOf(place) - positionOf(view_.front.previous(place));
  return positionOf(place) - match_.points[1];
}

int FrontSurroundings::count(int vertex, const std::array<double, 3>& bounds) const {
  const PlaceId place = idOf(vertex);
  if (!view_.front.hasEdge(place) || !view_.front.hasEdgeBefore(place))
    return AF2Surroundings::count(vertex, bounds);
  const int own = view_.front[place].ownCount;
  return own > 0 ? own : countOf(view_.front.sweep(place), bounds);
}

double FrontSurroundings::distanceToFront(Point2 point) const {
  // The distance to the base is an upper bound. The window of the step may not reach that far.
  const double toBase = distanceToSegment(point, match_.points[0], match_.points[1]);
  const Window reach{point.x - toBase, point.y - toBase, point.x + toBase, point.y + toBase};
  if (view_.near.window().contains(reach)) return nearestEdge(view_.near, point, toBase);
  Neighborhood wider;
  wider.gather(view_.front, index_, view_.chart, view_.base, reach);
  return nearestEdge(wider, point, toBase);
}

double FrontSurroundings::nearestEdge(const Neighborhood& near, Point2 point,
                                      double nearest) const {
  for (const Neighborhood::Edge& edge : near.edges())
    if (view_.front.hasEdge(edge.place))
      nearest = std::min(nearest, distanceToSegment(point, edge.from, edge.to));
  return nearest;
}

double FrontSurroundings::curvature(Point2 point) const {
  constexpr double kStep = 0.25;  // in wanted lengths: the scale that matters to an element
  const auto here = view_.chart.lift(point);
  if (!here) return 0;
  double largest = 0;
  for (Point2 d : {Point2{kStep, 0}, Point2{0, kStep}}) {
    const auto there = view_.chart.lift(point + d);
    if (!there) continue;
    const double away = distance(here->position, there->position);
    if (away > 0) largest = std::max(largest, distance(here->normal, there->normal) / away);
  }
  return largest * view_.chart.unit();
}

}  // namespace af2
