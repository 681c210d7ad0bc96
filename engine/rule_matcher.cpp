#include "engine/rule_matcher.h"

namespace af2 {

void RuleMatcher::moveTo(const StepView& view) {
  view_ = &view;
  const PlaceId a = view.base, b = view.front.next(a);
  match_.places[0] = a;
  match_.places[1] = b;
  match_.points[0] = view.chart.project(view.front[a].point).position;
  match_.points[1] = view.chart.project(view.front[b].point).position;
  lookAt(view.front.next(b), afterBase_);
  lookAt(view.front.previous(a), beforeBase_);
}

const RuleMatcher::Candidate& RuleMatcher::after(PlaceId place) {
  if (place == match_.places[1]) return afterBase_;
  lookAt(view_->front.next(place), other_);
  return other_;
}

const RuleMatcher::Candidate& RuleMatcher::before(PlaceId place) {
  if (place == match_.places[0]) return beforeBase_;
  lookAt(view_->front.previous(place), other_);
  return other_;
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
    if (!(test.form(edge - test.reference) <= view_->tolerance)) return false;
  }
  return true;
}

}  // namespace af2
