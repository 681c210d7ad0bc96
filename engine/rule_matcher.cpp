#include "engine/rule_matcher.h"

namespace af2 {

RuleMatcher::RuleMatcher(const StepView& view) : view_(view) {
  const PlaceId a = view.base, b = view.front.next(a);
  match_.places[0] = a;
  match_.places[1] = b;
  match_.points[0] = at(a).point.position;
  match_.points[1] = at(b).point.position;
  afterBase_ = at(view.front.next(b));
  beforeBase_ = at(view.front.previous(a));
}

RuleMatcher::Candidate RuleMatcher::after(PlaceId place) const {
  return place == match_.places[1] ? afterBase_ : at(view_.front.next(place));
}

RuleMatcher::Candidate RuleMatcher::before(PlaceId place) const {
  return place == match_.places[0] ? beforeBase_ : at(view_.front.previous(place));
}

bool RuleMatcher::isBound(const CompiledRule& rule, std::size_t index, VertexId id) const {
  const auto vertexAt = [&](std::size_t v) { return view_.front[match_.places[v]].vertex; };
  if (vertexAt(0) == id || vertexAt(1) == id) return true;
  for (std::size_t i = 0; i < index; ++i)
    if (vertexAt(static_cast<std::size_t>(rule.steps[i].vertex)) == id) return true;
  return false;
}

bool RuleMatcher::slopesFit(const CompiledRule& rule) const {
  for (const SlopeTest& test : rule.slopes) {
    const Point2 edge = match_.points[static_cast<std::size_t>(test.to)] -
                        match_.points[static_cast<std::size_t>(test.from)];
    if (!(test.form(edge - test.reference) <= view_.tolerance)) return false;
  }
  return true;
}

}  // namespace af2
