#include "engine/step/candidate_score.h"

#include <algorithm>
#include <cmath>

#include "engine/mesh/element_shape.h"
#include "engine/step/surroundings.h"

namespace af2 {
namespace {

/// Chart positions of an element's corners.
struct Corners {
  std::array<Point2, 4> points;
  int count;
  Corners(const RuleElement& element, const Match& match) : count(element.size()) {
    for (int i = 0; i < count; ++i)
      points[static_cast<std::size_t>(i)] =
          match.points[static_cast<std::size_t>(element.corners[static_cast<std::size_t>(i)])];
  }
  std::span<const Point2> span() const { return {points.data(), static_cast<std::size_t>(count)}; }
};

/// The badness of an element that turns left everywhere; infinite if it has none.
double badnessOf(const CompiledRules& rules, const Corners& corners, int level) {
  if (rules.fastMetric() && corners.count == 3)
    return rules.fastMetric()->triangleBadness(corners.points[0], corners.points[1],
                                               corners.points[2]);
  return rules.set().definition().metric->badnessAt(corners.span(), level).value_or(INFINITY);
}

void placeAffinePoints(const CompiledRule& rule, Match& match) {
  Point2* points = match.points.data() + rule.matchedCount;
  double x[AffineBatch::kCapacity], y[AffineBatch::kCapacity];
  rule.newPoints->evaluate(match.points.data(), x, y);
  for (int k = 0; k < rule.newCount; ++k) points[k] = {x[k], y[k]};
}

Refusal placeNewPoints(const CompiledRule& rule, const AF2Binding& binding, Match& match) {
  Point2* points = match.points.data() + rule.matchedCount;
  if (rule.newPoints) {
    placeAffinePoints(rule, match);
    return Refusal::None;
  }
  for (const auto& transform : rule.rule->definition().newVertices) {
    const auto point = transform->transformPoint(binding);
    if (!point || !std::isfinite(point->x) || !std::isfinite(point->y)) return Refusal::NoValue;
    *points++ = *point;
  }
  return Refusal::None;
}

Refusal requirementsHold(const CompiledRule& rule, const AF2Binding& binding) {
  for (const auto& requirement : rule.rule->definition().requirements) {
    const auto value = requirement->evaluate(binding);
    if (!value) return Refusal::NoValue;
    if (*value == 0) return Refusal::Require;
  }
  return Refusal::None;
}

/// The badnesses of the new elements as one number.
Refusal scoreElements(const CompiledRules& rules, const CompiledRule& rule, const Match& match,
                      int level, double& score) {
  const auto& elements = rule.rule->definition().elements;
  double largest = 0, sum = 0;
  bool isFirst = true;
  for (const RuleElement& element : elements) {
    const Corners corners(element, match);
    if (!turnsLeftEverywhere(corners.span())) return Refusal::Inverted;
    const double badness = badnessOf(rules, corners, level);
    if (!std::isfinite(badness)) return Refusal::NoValue;
    largest = isFirst ? badness : std::max(largest, badness);
    sum += badness;
    isFirst = false;
  }
  switch (rules.set().definition().scoreOf) {
    case ScoreOf::Max:
      score = largest;
      break;
    case ScoreOf::Sum:
      score = sum;
      break;
    case ScoreOf::Mean:
      score = sum / static_cast<double>(elements.size());
      break;
  }
  return Refusal::None;
}

}  // namespace

Refusal CandidateScorer::evaluate(const StepView& view, Candidate& candidate) const {
  const CompiledRule& rule = *candidate.rule;
  if (!rule.isPlain || !rule.newPoints) return evaluateOpenly(view, candidate);
  placeAffinePoints(rule, candidate.match);
  const Refusal refusal = scoreElements(rules_, rule, candidate.match, view.level, candidate.score);
  return refusal == Refusal::None ? judge(view, candidate) : refusal;
}

/// Where a rule asks about its surroundings, or has new vertices of any kind.
Refusal CandidateScorer::evaluateOpenly(const StepView& view, Candidate& candidate) const {
  const CompiledRule& rule = *candidate.rule;
  const FrontSurroundings surroundings(view, index_, rule, candidate.match, size_, valence_);
  const AF2Binding binding{candidate.matchedPoints(), view.level, &surroundings};
  if (const Refusal r = requirementsHold(rule, binding); r != Refusal::None) return r;
  if (const Refusal r = placeNewPoints(rule, binding, candidate.match); r != Refusal::None)
    return r;
  if (const Refusal r = scoreElements(rules_, rule, candidate.match, view.level, candidate.score);
      r != Refusal::None)
    return r;
  if (rule.rule->definition().cost) {
    const auto cost = rule.rule->definition().cost->evaluate(binding);
    if (!cost || !std::isfinite(*cost)) return Refusal::NoValue;
    candidate.score += *cost;
  }
  return judge(view, candidate);
}

Refusal CandidateScorer::judge(const StepView& view, const Candidate& candidate) const {
  const auto& acceptance = rules_.set().definition().acceptance;
  return !acceptance || acceptance->accepts(candidate.score, view.level) ? Refusal::None
                                                                         : Refusal::Score;
}

}  // namespace af2
