#include "engine/step/rule_matcher.h"

#include <cmath>

#include "engine/step/surroundings.h"

namespace af2 {

void RuleMatcher::moveTo(const StepView& view) {
  view_ = &view;
  lookedAt_ = 0;
  wanted_ = view.near.window();
  const DrawnBase& base = view.drawn;
  match_.places[0] = base.a.place;
  match_.places[1] = base.b.place;
  match_.points[0] = base.a.point.position;
  match_.points[1] = base.b.point.position;
  look(base.before, view.front.hasEdge(base.before.place), before_);
  look(base.after, view.front.hasEdge(base.b.place), after_);
}

void RuleMatcher::look(const DrawnBase::Corner& corner, bool hasEdge, Beside& beside) const {
  const auto vertexAt = [&](PlaceId id) { return view_->front[id].vertex; };
  const VertexId vertex = vertexAt(corner.place);
  beside.corner.place = corner.place;
  beside.corner.point.position = corner.point.position;
  beside.corner.point.view = corner.point.view;
  beside.hasEdge = hasEdge;
  beside.isOpen = hasEdge && corner.point.view == ChartView::Legal &&
                  vertex != vertexAt(match_.places[0]) && vertex != vertexAt(match_.places[1]);
}

const DrawnBase::Corner* RuleMatcher::neighbor(const BindingStep& step) {
  const PlaceId from = placeOf(step.from);
  const bool isAhead = step.kind == BindingStep::Kind::Next;
  if (!(isAhead ? view_->front.hasEdge(from) : view_->front.hasEdgeBefore(from))) return nullptr;
  const DrawnBase& base = view_->drawn;
  if (from == (isAhead ? base.b : base.a).place) return isAhead ? &base.after : &base.before;
  other_.place = isAhead ? view_->front.next(from) : view_->front.previous(from);
  const ChartPoint point = view_->chart.project(view_->front[other_.place].point);
  other_.point.position = point.position;
  other_.point.view = point.view;
  return &other_;
}

bool RuleMatcher::isBound(const CompiledPattern& pattern, std::size_t index, VertexId id) const {
  const auto vertexAt = [&](std::size_t v) { return view_->front[match_.places[v]].vertex; };
  if (vertexAt(0) == id || vertexAt(1) == id) return true;
  for (std::size_t i = 0; i < index; ++i)
    if (vertexAt(static_cast<std::size_t>(pattern.steps[i].vertex)) == id) return true;
  return false;
}

bool RuleMatcher::slopesFit(const CompiledPattern& pattern) const {
  for (const SlopeTest& test : pattern.slopes) {
    const Point2 edge = match_.points[static_cast<std::size_t>(test.to)] -
                        match_.points[static_cast<std::size_t>(test.from)];
    if (!test.fits(edge, view_->tolerance)) return false;
  }
  return true;
}

std::optional<Point2> RuleMatcher::computedPlace(const CompiledPattern& pattern,
                                                 const BindingStep& step) {
  const FrontSurroundings surroundings(*view_, index_, *pattern.rule, match_, size_, valence_);
  const auto matched = static_cast<std::size_t>(pattern.rule->matchedCount());
  const auto place = step.near->transformPoint(
      {std::span(match_.points.data(), matched), view_->level, &surroundings});
  if (!place || !std::isfinite(place->x) || !std::isfinite(place->y)) return std::nullopt;
  wanted_.include(
      {place->x - step.reach, place->y - step.reach, place->x + step.reach, place->y + step.reach});
  return place;
}

bool RuleMatcher::isNear(const CompiledPattern& pattern, const BindingStep& step, Point2 point) {
  const auto place = computedPlace(pattern, step);
  return place && distance(*place, point) <= step.reach;
}

}  // namespace af2
